// Mistakes put into the oracle on purpose have to be noticed: the comparison is able to fail.

#include <catch2/catch.hpp>

#include "tests/segment/answers.hpp"
#include "tests/support/environment.hpp"

namespace provis::test {
namespace {

/// Whether engine and mistaken oracle answer one of the first cases differently: with their lists, and by the
/// sets alone.
struct Noticed {
  bool lists = false, sets = false;
};

Noticed noticed(SegmentPlant plant, std::uint64_t cases = 400) {
  Noticed different;
  for (std::uint64_t seed = 0; seed < cases && !different.sets; ++seed) {
    const SegmentCase c = generate_segment(seed);
    const Answer found = engine_answer(c),
                 mistaken = answer_of(oracle_along(c.start.arrays, c.view(), plant));
    different.lists |= found != mistaken;
    different.sets |= found.visible != mistaken.visible || found.boundary != mistaken.boundary;
  }
  return different;
}

void require_noticed(SegmentPlant plant) {
  const Noticed different = noticed(plant);
  CHECK(different.lists);
  CHECK(different.sets);
}

}  // namespace

TEST_CASE("along a segment, without a mistake nothing is noticed") {
  CHECK_FALSE(noticed(SegmentPlant::none, case_count(8)).lists);
}
TEST_CASE("along a segment, a dropped occluder is noticed") {
  require_noticed(SegmentPlant::drop_an_occluder);
}
TEST_CASE("along a segment, a flipped tie is noticed") { require_noticed(SegmentPlant::flip_a_tie); }
TEST_CASE("along a segment, an epsilon between events is noticed") {
  require_noticed(SegmentPlant::use_an_epsilon);
}
TEST_CASE("along a segment, a forgotten camera event is noticed") {
  require_noticed(SegmentPlant::forget_camera_event);
}
TEST_CASE("along a segment, forgotten crossings are noticed") {
  require_noticed(SegmentPlant::forget_crossings);
}

}  // namespace provis::test
