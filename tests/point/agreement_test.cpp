// The engine against the oracle, on scenes made to be degenerate.

#include <catch2/catch.hpp>

#include "provis/witness.hpp"
#include "tests/point/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {

TEST_CASE("the engine gives the oracle's set on every generated case") {
  std::size_t visible = 0, hidden = 0;
  for (const std::uint64_t seed : seeds(100)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const std::vector<bool> expected = oracle_visible(c.arrays, c.view);
    REQUIRE(ids_of(engine_visible(c)) == ids_of(expected));
    for (const bool v : expected) ++(v ? visible : hidden);
  }
  // A generator that shows everything, or nothing, would test nothing.
  WARN(visible << " visible and " << hidden << " hidden triangles agreed");
  if (seeds(100).size() > 100) CHECK((10 * visible > hidden && 10 * hidden > visible));
}

TEST_CASE("every witness holds, by both checkers, and asking for witnesses changes no set") {
  PointOptions options;
  options.witnesses = true;
  for (const std::uint64_t seed : seeds(20)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const Scene scene(c.arrays);
    const VisibleSet set = visible_from_point(scene, c.view, options);
    REQUIRE(visible_flags(set) == engine_visible(c));
    REQUIRE(set.witnesses.size() == set.with(Status::visible).size());
    const RayChecker checker(scene, c.view);
    for (const Witness& w : set.witnesses) REQUIRE(checker.refuse(w) == "");
    REQUIRE(verify_witnesses(scene, c.view, set) == set.witnesses.size());
  }
}

TEST_CASE("random soups of some hundred triangles agree too") {
  for (const std::uint64_t seed : seeds(1)) {
    const Case c = random_soup(seed, 300);
    INFO("soup " << seed);
    REQUIRE(ids_of(engine_visible(c)) == ids_of(oracle_visible(c.arrays, c.view)));
  }
}

}  // namespace provis::test
