// Plain doubles, watched: the same answer as unwatched, and wrong signs wherever the answer is wrong.

#include "provis/check_doubles.hpp"

#include <catch2/catch.hpp>

#include <numeric>

#include "tests/point/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {
namespace {

std::uint64_t wrong_signs(const VisibleSet& set) {
  const auto& wrong = set.stats.signs.wrong;
  return std::accumulate(wrong.begin(), wrong.end(), std::uint64_t{0});
}

Context threads(int count) {
  Context context;
  context.threads = count;
  return context;
}

}  // namespace

TEST_CASE("checked doubles answer as unchecked ones, by the same signs") {
  PointOptions options;
  options.arithmetic = Arithmetic::doubles;
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const Scene scene(c.arrays);
    const VisibleSet plain = visible_from_point(scene, c.view, options);
    const VisibleSet checked = check_doubles(scene, c.view);
    REQUIRE(checked.status == plain.status);
    REQUIRE(checked.guarantee == Guarantee::sampled);
    // To check a sign takes the definitions of line and ray, which the unwatched run can do without: depth
    // lines, and input points in the image.
    auto asked = checked.stats.signs.decided;
    for (const Predicate p : {Predicate::coplanar, Predicate::turn}) {
      const auto k = static_cast<std::size_t>(p);
      REQUIRE(asked[k] >= plain.stats.signs.decided[k]);
      asked[k] = plain.stats.signs.decided[k];
    }
    REQUIRE(asked == plain.stats.signs.decided);
    REQUIRE(checked.stats.checked);
    REQUIRE_FALSE(plain.stats.checked);
    REQUIRE(wrong_signs(plain) == 0);
  }
}

TEST_CASE("a wrong set has wrong signs behind it") {
  std::size_t wrong_sets = 0, cases = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const VisibleSet checked = check_doubles(Scene(c.arrays), c.view);
    ++cases;
    if (visible_flags(checked) == engine_visible(c)) continue;
    ++wrong_sets;
    REQUIRE(wrong_signs(checked) > 0);
  }
  if (cases > 100) CHECK(wrong_sets > 0);
}

TEST_CASE("wrong signs do not depend on the threads") {
  for (const std::uint64_t seed : seeds(2)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const Scene scene(c.arrays);
    const VisibleSet one = check_doubles(scene, c.view, threads(1)),
                     many = check_doubles(scene, c.view, threads(7));
    CHECK(one.stats.signs.wrong == many.stats.signs.wrong);
    CHECK(one.status == many.status);
  }
}

}  // namespace provis::test
