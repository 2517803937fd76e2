// Plain doubles along segments, watched: the same answer as unwatched, and wrong signs wherever it is wrong.

#include <catch2/catch.hpp>

#include <numeric>

#include "provis/check_doubles.hpp"
#include "tests/segment/engine_cases.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

std::uint64_t wrong_signs(const SegmentSet& set) {
  const auto& wrong = set.set.stats.signs.wrong;
  return std::accumulate(wrong.begin(), wrong.end(), std::uint64_t{0});
}

SegmentOptions doubles() {
  SegmentOptions options;
  options.arithmetic = Arithmetic::doubles;
  return options;
}

}  // namespace

TEST_CASE("checked doubles answer as unchecked ones, by the same signs") {
  for (const std::uint64_t seed : seeds(20)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    const SegmentSet plain = visible_from_segment(scene, c.view, doubles());
    const SegmentSet checked = check_doubles(scene, c.view);
    REQUIRE(checked.set.status == plain.set.status);
    REQUIRE(checked.boundary == plain.boundary);
    REQUIRE(checked.set.stats.signs.decided == plain.set.stats.signs.decided);
    REQUIRE(checked.set.stats.checked);
    REQUIRE_FALSE(plain.set.stats.checked);
    REQUIRE(wrong_signs(plain) == 0);
    for (int p = 0; p < predicate_count; ++p) {
      std::uint64_t decided = 0;
      for (int t = 0; t < tier_count; ++t)
        decided += checked.set.stats.signs.at(static_cast<Predicate>(p), static_cast<Tier>(t));
      REQUIRE(checked.set.stats.signs.wrong_of(static_cast<Predicate>(p)) <= decided);
    }
  }
}

TEST_CASE("in general position no sign along a segment is wrong") {
  std::uint64_t orders = 0;
  for (const std::uint64_t seed : seeds(4)) {
    Random random(seed);
    const auto point = [&](double size) {
      const double x = random.unit() - 0.5, y = random.unit() - 0.5, z = random.unit() - 0.5;
      return size * Vec3d{x, y, z};
    };
    SceneArrays arrays;
    for (std::uint32_t k = 0; k < 40; ++k) {
      const Vec3d at = point(8);
      arrays.vertices.insert(arrays.vertices.end(), {at + point(4), at + point(4), at + point(4)});
      arrays.triangles.push_back({3 * k, 3 * k + 1, 3 * k + 2});
      arrays.triangle_flags.push_back(random.chance(20) ? see_through : 0);
    }
    const SegmentSet set = check_doubles(Scene(arrays), {point(2), point(2), {Frame{}}, {9, 7}});
    INFO("soup " << seed);
    orders += set.set.stats.signs.at(Predicate::event_order, Tier::filter);
    REQUIRE(wrong_signs(set) == 0);
  }
  CHECK(orders > 100);
}

TEST_CASE("a wrong set along a segment has wrong signs behind it") {
  std::size_t wrong_sets = 0, clean = 0, cases = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    const SegmentSet checked = check_doubles(scene, c.view);
    ++cases;
    clean += wrong_signs(checked) == 0;
    if (checked.set.status == visible_from_segment(scene, c.view).set.status) continue;
    ++wrong_sets;
    REQUIRE(wrong_signs(checked) > 0);
  }
  WARN(wrong_sets << " wrong sets and " << clean << " without a wrong sign, of " << cases);
  if (cases > 100) CHECK((wrong_sets > 0 && clean > 0));
}

TEST_CASE("wrong signs along a segment do not depend on the threads") {
  Context one, many;
  one.threads = 1;
  many.threads = 7;
  for (const std::uint64_t seed : seeds(4)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    CHECK(check_doubles(scene, c.view, one).set.stats.signs.wrong ==
          check_doubles(scene, c.view, many).set.stats.signs.wrong);
  }
}

}  // namespace provis::test
