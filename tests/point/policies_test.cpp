// Four arithmetic policies: three that must agree, and one that must end.

#include <catch2/catch.hpp>

#include "tests/point/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {

TEST_CASE("exact arithmetic throughout gives the chain's set") {
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    INFO(describe(c));
    REQUIRE(engine_visible(c, Arithmetic::exact) == engine_visible(c));
  }
}

TEST_CASE("MPFR throughout gives the chain's set") {
  for (const std::uint64_t seed : seeds(2)) {
    const Case c = generate(seed);
    INFO(describe(c));
    REQUIRE(engine_visible(c, Arithmetic::mpfr) == engine_visible(c));
  }
}

TEST_CASE("plain doubles end on every case, claim nothing, and are sometimes wrong") {
  PointOptions options;
  options.arithmetic = Arithmetic::doubles;
  std::size_t wrong = 0, cases = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const VisibleSet set = visible_from_point(Scene(c.arrays), c.view, options);
    REQUIRE(set.guarantee == Guarantee::sampled);
    wrong += visible_flags(set) != engine_visible(c);
    ++cases;
  }
  WARN("plain doubles are wrong on " << wrong << " of " << cases << " cases");
  if (cases > 100) CHECK(wrong > 0);
}

TEST_CASE("the tiers behind the filter are all needed by degenerate scenes") {
  SignCounts sum;
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    sum += visible_from_point(Scene(c.arrays), c.view).stats.signs;
  }
  for (const Tier tier : {Tier::structure, Tier::filter, Tier::interval, Tier::exact}) {
    std::uint64_t decided = 0;
    for (int p = 0; p < predicate_count; ++p) decided += sum.at(static_cast<Predicate>(p), tier);
    INFO(name(tier));
    CHECK(decided > 0);
  }
}

}  // namespace provis::test
