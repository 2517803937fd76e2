// The catalogue of hard segments: what it has to hold, and the oracle's answers to it.

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

#include "tests/segment/hard_segment.hpp"

namespace provis::test {
namespace {

const std::filesystem::path folder = PROVIS_SOURCE_DIR "/data/hard/segment";

const std::vector<HardSegment>& catalogue() {
  static const std::vector<HardSegment> cases = load_hard_segments(folder);
  return cases;
}

/// How many cases show that the oracle makes this mistake.
int caught(SegmentPlant plant) {
  int different = 0;
  for (const HardSegment& c : catalogue())
    different += answer_of(oracle_along(c.input.start.arrays, c.input.view(), plant)) != c.answer;
  return different;
}

}  // namespace

TEST_CASE("the catalogue explains at least forty hard segments") {
  CHECK(catalogue().size() >= 40);
  for (const HardSegment& c : catalogue()) {
    INFO(c.input.start.name);
    CHECK((!c.why.empty() && c.why.find_first_of("\n|") == std::string::npos));
    CHECK(!c.because.empty());
  }
}

TEST_CASE("the README of the hard segments ends with the table of its files") {
  std::ostringstream readme;
  readme << std::ifstream(folder / "README.md").rdbuf();
  const std::string all = readme.str(), end = "\n\n" + hard_table(catalogue());
  INFO("data/hard/segment/README.md has to end with" << end);
  CHECK((all.size() > end.size() && all.compare(all.size() - end.size(), end.size(), end) == 0));
}

TEST_CASE("the oracle gives the expected answer of every hard segment") {
  for (const HardSegment& c : catalogue()) {
    INFO(c.because << "\n" << describe(c.input));
    CHECK(difference(answer_of(oracle_along(c.input.start.arrays, c.input.view())), c.answer) == "");
  }
}

TEST_CASE("hard segments catch a dropped occluder") { CHECK(caught(SegmentPlant::drop_an_occluder) > 0); }
TEST_CASE("hard segments catch a flipped tie") { CHECK(caught(SegmentPlant::flip_a_tie) > 0); }
TEST_CASE("hard segments catch an epsilon") { CHECK(caught(SegmentPlant::use_an_epsilon) > 0); }
TEST_CASE("hard segments catch a forgotten camera event") {
  CHECK(caught(SegmentPlant::forget_camera_event) > 0);
}
TEST_CASE("hard segments catch forgotten crossings") { CHECK(caught(SegmentPlant::forget_crossings) > 0); }

}  // namespace provis::test
