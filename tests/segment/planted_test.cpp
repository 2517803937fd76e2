// Mistakes put into the oracle on purpose have to be noticed: the comparison is able to fail.

#include <catch2/catch.hpp>

#include "tests/segment/answers.hpp"

namespace provis::test {
namespace {

/// How many of the first cases the engine and the mistaken oracle answer differently: with their lists, and
/// by the sets alone.
struct Noticed {
  int lists = 0, sets = 0;
};

Noticed noticed(SegmentPlant plant) {
  Noticed different;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const SegmentCase c = generate_segment(seed);
    const Answer found = engine_answer(c),
                 mistaken = answer_of(oracle_along(c.start.arrays, c.view(), plant));
    different.lists += found != mistaken;
    different.sets += found.visible != mistaken.visible || found.boundary != mistaken.boundary;
  }
  return different;
}

void require_noticed(SegmentPlant plant) {
  const Noticed different = noticed(plant);
  CHECK(different.lists > 0);
  CHECK(different.sets > 0);
}

}  // namespace

TEST_CASE("along a segment, without a mistake nothing is noticed") {
  CHECK(noticed(SegmentPlant::none).lists == 0);
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
