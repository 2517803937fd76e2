// Checks on the generator, the transformations and the ray checker, and of the oracle against random rays.

#include <catch2/catch.hpp>

#include <gmpxx.h>

#include <cmath>
#include <sstream>

#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/random.hpp"
#include "tests/support/ray_check.hpp"
#include "tests/support/transform.hpp"

namespace provis::test {

namespace {

std::string text_of(const Case& c) {
  std::ostringstream out;
  write_text(out, c);
  return out.str();
}

Vec3<mpq_class> exact(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// value = mantissa * 2^exponent; the denominator has to be a power of two.
Dyadic dyadic(const mpq_class& value) {
  const auto bits = mpz_scan1(value.get_den_mpz_t(), 0);
  REQUIRE(mpz_class(value.get_den() >> bits) == 1);
  return {value.get_num().get_str(), -static_cast<long>(bits)};
}

Vec3<Dyadic> dyadic(const Vec3<mpq_class>& v) { return {dyadic(v.x), dyadic(v.y), dyadic(v.z)}; }

/// A ray of the view through a random point of a window; says nothing yet about a primitive.
Witness random_ray(const PointView& view, Random& random) {
  const Frame& f = random.pick_from(view.frames);
  const auto between = [&](const mpq_class& lo, const mpq_class& hi) {
    return mpq_class(lo + (hi - lo) * mpq_class(random.unit()));
  };
  const mpq_class x = between(f.window.x0, f.window.x1), y = between(f.window.y0, f.window.y1);
  const Vec3<mpq_class> across = x * exact(f.right) + y * exact(f.up);
  if (view.projection == Projection::parallel) {
    return {0, dyadic(exact(view.eye) + across), dyadic(exact(f.forward))};
  }
  return {0, dyadic(exact(view.eye)), dyadic(exact(f.forward) + across)};
}

Witness witness(PrimitiveId id, const Vec3d& origin, const Vec3d& direction) {
  return {id, dyadic(exact(origin)), dyadic(exact(direction))};
}

/// Changed cases that have to be answered like the original.
std::vector<Variant> variants_of(const Case& c, std::uint64_t seed) {
  std::vector<Variant> all{permute_triangles(c, seed), rotate_corners(c, seed),    split_vertices(c),
                           permute_axes(c, {1, 2, 0}), permute_axes(c, {1, 0, 2}), mirror(c, int(seed % 3))};
  const std::optional<Variant> possible[] = {scale(c, 7), scale(c, -90), translate(c, {1, -2, 4}),
                                             cut_triangles(c, seed)};
  for (const std::optional<Variant>& v : possible) {
    if (v) all.push_back(*v);
  }
  return all;
}

/// Fowler, Noll, Vo: FNV-1a.
std::uint64_t fingerprint(const std::string& text) {
  std::uint64_t h = 0xcbf29ce484222325u;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return h;
}

}  // namespace

TEST_CASE("generated cases fit the contract of a query") {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    const Case c = generate(seed);
    INFO(describe(c));
    REQUIRE(c.arrays.triangle_flags.size() == c.arrays.triangles.size());
    REQUIRE(!c.arrays.triangles.empty());
    REQUIRE(c.arrays.triangles.size() < 80);
    for (const Vec3d& v : c.arrays.vertices) REQUIRE(std::isfinite(v.x + v.y + v.z));
    REQUIRE(c.view.frames.size() == (c.view.projection == Projection::omni ? 6u : 1u));
    for (const Frame& f : c.view.frames) {
      REQUIRE(dot(cross(exact(f.right), exact(f.up)), exact(f.forward)) != 0);
      REQUIRE(f.window.x0 < f.window.x1);
      REQUIRE(f.window.y0 < f.window.y1);
    }
  }
}

TEST_CASE("most generated cases show something, and most hide something") {
  int shows = 0, hides = 0, count = 1000;
  for (int seed = 0; seed < count; ++seed) {
    const Case c = generate(static_cast<std::uint64_t>(seed));
    std::size_t visible = 0;
    for (const bool v : oracle_visible(c.arrays, c.view)) visible += v ? 1 : 0;
    shows += visible > 0 ? 1 : 0;
    hides += visible < c.arrays.triangles.size() ? 1 : 0;
  }
  CHECK(shows > count * 3 / 4);
  CHECK(hides > count * 3 / 4);
}

TEST_CASE("a seed gives the same case on every machine") {
  std::string all;
  for (std::uint64_t seed = 0; seed < 200; ++seed) all += text_of(generate(seed));
  all += text_of(random_soup(5, 20));
  // Changes with the generator only; a compiler that changes it makes printed seeds worthless.
  CHECK(fingerprint(all) == 0x62828ba1ab92e829u);
}

TEST_CASE("the text form of a case reads back bit for bit") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const Case c = generate(seed);
    std::istringstream in(text_of(c));
    const Case back = read_text(in);
    REQUIRE(back.arrays.vertices == c.arrays.vertices);
    REQUIRE(back.arrays.triangles == c.arrays.triangles);
    REQUIRE(back.arrays.triangle_flags == c.arrays.triangle_flags);
    REQUIRE(back.view.eye == c.view.eye);
    REQUIRE(back.view.frames == c.view.frames);
    REQUIRE(text_of(back) == text_of(c));
  }
  std::istringstream broken("provis-case 1 name a\nseed x");
  CHECK_THROWS_WITH(read_text(broken), Catch::Contains("'x' is no integer"));
}

TEST_CASE("the oracle holds to the invariances of R7") {
  std::size_t tried = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Case c = generate(seed);
    const std::vector<bool> expected = oracle_visible(c.arrays, c.view);
    for (const Variant& v : variants_of(c, seed)) {
      INFO(describe(v.changed));
      REQUIRE(pull_back(v, oracle_visible(v.changed.arrays, v.changed.view)) == expected);
      ++tried;
    }
  }
  CHECK(tried > 3400);  // of 4000: translations and cuts are not always exact
}

TEST_CASE("an added occluder makes nothing visible") {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Case c = generate(seed);
    const Variant v = add_triangle(c, seed);
    const std::vector<bool> before = oracle_visible(c.arrays, c.view);
    const std::vector<bool> after = pull_back(v, oracle_visible(v.changed.arrays, v.changed.view));
    for (std::size_t t = 0; t < before.size(); ++t) {
      INFO(describe(v.changed));
      REQUIRE((before[t] || !after[t]));
    }
  }
}

TEST_CASE("generated cases catch each planted mistake") {
  for (const Plant plant : {Plant::drop_an_occluder, Plant::flip_a_tie, Plant::use_an_epsilon}) {
    int caught = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const Case c = generate(seed);
      caught += oracle_visible(c.arrays, c.view) != oracle_visible(c.arrays, c.view, plant) ? 1 : 0;
    }
    CAPTURE(int(plant));
    CHECK(caught >= 10);
  }
}

TEST_CASE("what cannot be changed exactly is not changed") {
  Case c;
  c.arrays.vertices = {{1, 0, 0}, {0x1p-1074, 1, 0}, {0, 0, 1}};
  c.arrays.triangles = {{0, 1, 2}};
  c.arrays.triangle_flags = {0};
  c.view.frames = {Frame{}};
  CHECK_FALSE(scale(c, -1));
  CHECK_FALSE(scale(c, 1024));
  CHECK(scale(c, 1));
  CHECK_FALSE(translate(c, {1, 0, 0}));
  CHECK(translate(c, {0, 1, 0}));
}

TEST_CASE("a case is answered alike by one thread and by several, and id by id") {
  const Case c = random_soup(3, 600);
  const std::vector<bool> all = oracle_visible(c.arrays, c.view, Plant::none, 1);
  CHECK(oracle_visible(c.arrays, c.view, Plant::none, 5) == all);
  const std::vector<PrimitiveId> ids{599, 0, 17, 300};
  const std::vector<bool> some = subtract_check(c.arrays, c.view, ids);
  for (std::size_t i = 0; i < ids.size(); ++i) CHECK(some[i] == all[ids[i]]);
}

TEST_CASE("what a random exact ray sees is in the oracle's set") {
  std::size_t visible = 0, witnessed = 0;
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    const Case c = generate(seed);
    const std::vector<bool> answer = oracle_visible(c.arrays, c.view);
    const RayChecker checker(c.arrays, c.view);
    std::vector<bool> seen(answer.size(), false);
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      Witness ray = random_ray(c.view, random);
      for (ray.primitive = 0; ray.primitive < answer.size(); ++ray.primitive) {
        if (!seen[ray.primitive]) seen[ray.primitive] = checker.refuse(ray).empty();
      }
    }
    for (std::size_t t = 0; t < answer.size(); ++t) {
      INFO("triangle " << t << " of " << describe(c));
      REQUIRE((answer[t] || !seen[t]));
      visible += answer[t] ? 1 : 0;
      witnessed += seen[t] ? 1 : 0;
    }
  }
  CHECK(witnessed * 2 > visible);  // otherwise the rays would prove nothing
}

TEST_CASE("what the oracle calls visible is proven by an exact ray") {
  std::size_t proven = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const Case c = generate(seed);
    const RayChecker checker(c.arrays, c.view);
    for (const Witness& w : oracle_witnesses(c.arrays, c.view)) {
      INFO("triangle " << w.primitive << " of " << describe(c));
      REQUIRE(checker.refuse(w) == "");
      ++proven;
    }
  }
  CHECK(proven > 1000);
}

TEST_CASE("a witness holds or is refused for a reason") {
  SceneArrays scene;
  scene.vertices = {{-2, -2, -2}, {2, -2, -2}, {0, 2, -2}, {-2, -2, -4}, {2, -2, -4}, {0, 6, -4}, {0, 0, -6}};
  scene.triangles = {{0, 1, 2}, {3, 4, 5}, {5, 4, 3}, {0, 2, 1}, {3, 4, 6}};
  scene.triangle_flags = {0, 0, single_sided, see_through, single_sided};
  PointView view;
  view.frames = {Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {-2, 2, -2, 2}}};
  const RayChecker checker(scene, view);
  const auto reason = [&](PrimitiveId id, const Vec3d& d) { return checker.refuse(witness(id, {}, d)); };

  CHECK(reason(0, {0, 0, -1}).empty());
  CHECK(reason(0, {0, 0, -0x1p-900}).empty());
  CHECK(reason(3, {0, 0, -1}).empty());  // coplanar with an occluder, which is no obstacle
  CHECK(reason(1, {0, 0, -1}) == "triangle 0 meets the segment");
  CHECK(reason(1, {0, 1.03125, -1}) == "");  // past the tip of triangle 0
  CHECK(reason(1, {0, 1, -1}) ==
        "triangle 0 meets the segment");  // through that tip: the closed segment is met
  CHECK(reason(2, {0, 0, -1}) == "the triangle is edge-on, degenerate or culled");
  CHECK(reason(0, {0, 0, 1}) == "the ray does not belong to the view");
  CHECK(reason(0, {3, 0, -1}) == "the ray does not belong to the view");
  CHECK(reason(0, {0, 0, 0}) == "the direction is zero");
  CHECK(reason(0, {2, 0, -1}) == "the ray misses the triangle's relative interior");
  CHECK(reason(0, {0, -1, -1}) == "the ray misses the triangle's relative interior");
  CHECK(checker.refuse(witness(0, {0, 0, 1}, {0, 0, -1})) == "the ray does not belong to the view");
  CHECK(reason(9, {0, 0, -1}) == "no such triangle");
}

TEST_CASE("spheres are refused by the oracle") {
  SceneArrays scene;
  scene.spheres.push_back({});
  PointView view;
  view.frames = {Frame{}};
  CHECK_THROWS_AS(oracle_visible(scene, view), std::logic_error);
}

}  // namespace provis::test
