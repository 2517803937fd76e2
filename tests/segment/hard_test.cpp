// The engine on the catalogue of hard segments: every certified policy gives the answer that follows by
// reasoning.

#include <catch2/catch.hpp>

#include "tests/segment/hard_segment.hpp"

namespace provis::test {
namespace {

const std::vector<HardSegment>& catalogue() {
  static const std::vector<HardSegment> cases = load_hard_segments(PROVIS_SOURCE_DIR "/data/hard/segment");
  return cases;
}

void require_expected_answers(Arithmetic arithmetic) {
  for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain}) {
    SegmentOptions options;
    options.arithmetic = arithmetic;
    options.engine = engine;
    for (const HardSegment& c : catalogue()) {
      INFO(c.because << "\n" << describe(c.input));
      CHECK(difference(engine_answer(c.input, options), c.answer) == "");
    }
  }
}

}  // namespace

TEST_CASE("the view of every hard segment passes the check") {
  for (const HardSegment& c : catalogue()) {
    INFO(describe(c.input));
    CHECK_NOTHROW(check(c.input.view()));
  }
}

TEST_CASE("the chain gives the expected answer of every hard segment") {
  require_expected_answers(Arithmetic::chain);
}
TEST_CASE("exact arithmetic gives the expected answer of every hard segment") {
  require_expected_answers(Arithmetic::exact);
}
TEST_CASE("MPFR gives the expected answer of every hard segment") {
  require_expected_answers(Arithmetic::mpfr);
}

TEST_CASE("plain doubles end on every hard segment, and are wrong on some") {
  SegmentOptions options;
  options.arithmetic = Arithmetic::doubles;
  int wrong = 0;
  for (const HardSegment& c : catalogue()) {
    INFO(describe(c.input));
    SegmentSet set;
    wrong += engine_answer(c.input, options, {}, &set) != c.answer;
    CHECK(set.set.guarantee == Guarantee::sampled);
  }
  // A catalogue on which rounding does no harm would not be hard.
  CHECK(wrong > 0);
}

}  // namespace provis::test
