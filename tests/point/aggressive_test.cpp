// The aggressive method: what it calls visible is visible, and what its guarantee promises is found.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "provis/error.hpp"
#include "provis/witness.hpp"
#include "tests/point/answers.hpp"
#include "tests/point/fragments.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

VisibleSet aggressive(const Case& c, const PixelGrid& pixels, Arithmetic arithmetic = Arithmetic::chain,
                      int threads = 0) {
  PointOptions options;
  options.method = Method::aggressive;
  options.arithmetic = arithmetic;
  options.pixels = pixels;
  options.witnesses = arithmetic != Arithmetic::doubles;
  Context context;
  context.threads = threads;
  return visible_from_point(Scene(c.arrays), c.view, options, context);
}

/// Ids that are in the first list and not in the second.
std::vector<PrimitiveId> missing(const std::vector<bool>& wanted, const std::vector<bool>& found) {
  std::vector<PrimitiveId> ids;
  for (std::size_t t = 0; t < wanted.size(); ++t)
    if (wanted[t] && !found[t]) ids.push_back(static_cast<PrimitiveId>(t));
  return ids;
}

PixelGrid small_grid(std::uint64_t seed) {
  const PixelGrid grids[] = {{1, 1}, {2, 1}, {3, 2}, {4, 4}, {5, 3}};
  return grids[seed % 5];
}

/// A closed surface of quadrilaterals cut in two: point(u, v) with both in [0, 1].
template <class Point>
Case closed_surface(int n, int m, const Point& point, const PointView& view) {
  Case c;
  c.name = "closed surface";
  c.view = view;
  for (int j = 0; j <= m; ++j)
    for (int i = 0; i < n; ++i) c.arrays.vertices.push_back(point(double(i) / n, double(j) / m));
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * n + i % n); };
  for (int j = 0; j < m; ++j)
    for (int i = 0; i < n; ++i) {
      c.arrays.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      c.arrays.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  c.arrays.triangle_flags.assign(c.arrays.triangles.size(), 0);
  return c;
}

constexpr double turn = 2 * std::numbers::pi;

Case sphere(int n) {
  LookAt camera;
  camera.eye = {0.3, 0.2, 5};
  camera.fovy_degrees = 30;
  return closed_surface(
      n, n / 2,
      [](double u, double v) {
        const double r = std::sin(turn / 2 * v);
        return Vec3d{r * std::cos(turn * u), std::cos(turn / 2 * v), r * std::sin(turn * u)};
      },
      look_at(camera));
}

Case torus(int n) {
  LookAt camera;
  camera.eye = {0, 3, 4};
  camera.direction = {0.1, -3, -4};
  return closed_surface(
      n, n,
      [](double u, double v) {
        const double r = 1.5 + 0.6 * std::cos(turn * v);
        return Vec3d{r * std::cos(turn * u), 0.6 * std::sin(turn * v), r * std::sin(turn * u)};
      },
      look_at(camera));
}

}  // namespace

TEST_CASE("the aggressive set is a part of the oracle's on every generated case, and every witness holds") {
  std::size_t found = 0, visible = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const VisibleSet set = aggressive(c, small_grid(seed));
    const std::vector<bool> expected = oracle_visible(c.arrays, c.view);
    REQUIRE(set.guarantee == Guarantee::aggressive);
    REQUIRE(missing(visible_flags(set), expected).empty());
    REQUIRE(set.with(Status::hidden).empty());
    REQUIRE(set.witnesses.size() == set.with(Status::visible).size());
    const RayChecker checker(c.arrays, c.view);
    for (const Witness& w : set.witnesses) REQUIRE(checker.refuse(w) == "");
    found += set.with(Status::visible).size();
    visible += static_cast<std::size_t>(std::count(expected.begin(), expected.end(), true));
  }
  WARN("found " << found << " of " << visible << " visible triangles");
  CHECK(2 * found > visible);
}

TEST_CASE("every triangle with a completely visible fragment is found on every generated case") {
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const PixelGrid grid = small_grid(seed);
    REQUIRE(missing(completely_visible_somewhere(c, grid), visible_flags(aggressive(c, grid))).empty());
  }
}

TEST_CASE("every completely visible triangle of a finely tessellated surface is found") {
  for (const Case& c : {sphere(44), torus(32)}) {
    const std::vector<bool> wanted = completely_visible_somewhere(c, {1, 1});
    CHECK(4 * std::count(wanted.begin(), wanted.end(), true) > static_cast<long>(wanted.size()));
    // With few pixels most triangles are smaller than one.
    for (const PixelGrid grid : {PixelGrid{1, 1}, PixelGrid{4, 4}, PixelGrid{40, 30}}) {
      INFO(grid.width << "x" << grid.height);
      CHECK(missing(wanted, visible_flags(aggressive(c, grid))).empty());
    }
    // The property is able to fail: a ray in each pixel's middle finds no such set.
    PointOptions plain;
    plain.method = Method::sampled;
    plain.pixels = {4, 4};
    CHECK_FALSE(missing(wanted, visible_flags(visible_from_point(Scene(c.arrays), c.view, plain))).empty());
  }
}

TEST_CASE("a triangle of 1e-15 of the window is found") {
  Case c;
  c.view.frames = {Frame{}};
  const double x = 0.3, y = 0.7, d = 0x1p-51;
  c.arrays.vertices = {{x, y, -1}, {x + d, y, -1}, {x, y + d, -1}, {-9, -9, -2}, {9, -9, -2}, {0, 9, -2}};
  c.arrays.triangles = {{0, 1, 2}, {3, 4, 5}};
  c.arrays.triangle_flags = {0, 0};
  CHECK(aggressive(c, {3, 3}).with(Status::visible) == std::vector<PrimitiveId>{0, 1});
}

TEST_CASE("threads change nothing of an aggressive answer") {
  for (const int scene : {0, 1}) {
    Case c = random_soup(static_cast<std::uint64_t>(scene) + 21, 1500);
    if (scene == 1) c.view = omni(c.view.eye);
    const VisibleSet one = aggressive(c, {64, 48}, Arithmetic::chain, 1);
    for (const int threads : {2, 7}) {
      const VisibleSet other = aggressive(c, {64, 48}, Arithmetic::chain, threads);
      REQUIRE(one.status == other.status);
      REQUIRE(one.stats.sampling.locations == other.stats.sampling.locations);
      REQUIRE(one.stats.sampling.most == other.stats.sampling.most);
      for (std::size_t k = 0; k < one.witnesses.size(); ++k) {
        REQUIRE(one.witnesses[k].direction.x.mantissa == other.witnesses[k].direction.x.mantissa);
        REQUIRE(one.witnesses[k].direction.y.mantissa == other.witnesses[k].direction.y.mantissa);
      }
    }
  }
}

TEST_CASE("every certain arithmetic holds the guarantee, and doubles claim nothing") {
  for (const std::uint64_t seed : seeds(1)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const std::vector<bool> wanted = completely_visible_somewhere(c, {2, 2});
    const std::vector<bool> visible = oracle_visible(c.arrays, c.view);
    for (const Arithmetic a : {Arithmetic::mpfr, Arithmetic::exact}) {
      const std::vector<bool> found = visible_flags(aggressive(c, {2, 2}, a));
      REQUIRE(missing(wanted, found).empty());
      REQUIRE(missing(found, visible).empty());
    }
    REQUIRE(aggressive(c, {2, 2}, Arithmetic::doubles).guarantee == Guarantee::sampled);
  }
}

TEST_CASE("one sample in the middle of every pixel is part of what is looked along") {
  const Case c = random_soup(3, 200);
  PointOptions plain;
  plain.method = Method::sampled;
  plain.pixels = {16, 16};
  const VisibleSet sampled = visible_from_point(Scene(c.arrays), c.view, plain);
  CHECK(sampled.stats.sampling.locations == 256);
  CHECK(missing(visible_flags(sampled), visible_flags(aggressive(c, {16, 16}))).empty());
}

TEST_CASE("a grid without pixels is refused, and so is a subdivision") {
  const Case c = random_soup(3, 10);
  const auto refused = [&](const PointOptions& options) {
    try {
      visible_from_point(Scene(c.arrays), c.view, options);
    } catch (const Error& e) {
      return e.code() == Error::Code::usage;
    }
    return false;
  };
  PointOptions options;
  options.method = Method::aggressive;
  options.pixels = {0, 5};
  CHECK(refused(options));
  options.pixels = {5, 5};
  CHECK_FALSE(refused(options));
  options.subdivision = true;
  CHECK(refused(options));
}

}  // namespace provis::test
