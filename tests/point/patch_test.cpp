// Connected patches: what they cover, and the gaps through which they must not.

#include <catch2/catch.hpp>

#include <cmath>

#include "src/point/patch.hpp"
#include "tests/point/answers.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

/// Facets in the plane at distance 1 before the eye, corners by window coordinates and given ids.
struct Sheet {
  std::uint32_t corner(double x, double y) {
    points.push_back({x, y});
    return static_cast<std::uint32_t>(points.size() - 1);
  }

  /// Anticlockwise corners; depth: larger is nearer.
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, double depth = 1) {
    Facet f;
    const std::uint32_t ids[3] = {a, b, c};
    f.box = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    for (int k = 0; k < 3; ++k) {
      const auto [x, y] = points[ids[k]];
      const auto [u, v] = points[ids[(k + 1) % 3]];
      f.points[k] = ids[k];
      f.box = {std::min(f.box.x0, x), std::max(f.box.x1, x), std::min(f.box.y0, y), std::max(f.box.y1, y)};
      f.inside[k] = {y - v, u - x, x * v - u * y, 1e-12};
    }
    f.depth = {0, 0, depth, 1e-12};
    facets.facets.push_back(f);
  }

  double cover(const Window& w) const {
    Patch patch(facets);
    for (std::uint32_t f = 0; f < facets.facets.size(); ++f) patch.add(f, w);
    return patch.cover(w);
  }

  std::vector<std::pair<double, double>> points;
  Facets facets;
};

/// n x n squares of side 1 from (0, 0), two triangles each; corner ids are shared.
Sheet grid(int n, double depth = 1) {
  Sheet s;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) s.corner(i, j);
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(j * (n + 1) + i); };
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      s.add(at(i, j), at(i + 1, j), at(i + 1, j + 1), depth);
      s.add(at(i, j), at(i + 1, j + 1), at(i, j + 1), depth);
    }
  return s;
}

constexpr double none = -HUGE_VAL;

/// Two triangles with one edge in common, the window's lower half and its upper half, before 130 small ones.
/// All are seen: the lower one recedes fast from that edge. Its far corner is so far that its plane
/// overflows, while the scale of the frame keeps all edges within range.
Case wall_with_unknown_plane() {
  Case c;
  constexpr double scale = 0x1p-200, near = 0x1p280, far = 0x1p745;
  const auto at = [](double distance, double x, double y) {
    return Vec3d{distance * x, distance * y, -distance};
  };
  const Vec3d p = at(near, -10, 0), q = at(near, 10, 0.5);
  add_triangle(c.arrays, q, p, at(far, 0, -20));
  add_triangle(c.arrays, p, q, at(near, 0, 20));
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 13; ++i) {
      const double x = -0.9 + 0.13 * i, y = -0.95 + 0.06 * j, distance = 1.03 * near;
      add_triangle(c.arrays, at(distance, x, y), at(distance, x + 0.1, y), at(distance, x, y + 0.05));
    }
  c.view.frames = {Frame{{scale, 0, 0}, {0, scale, 0}, {0, 0, -scale}, {}}};
  return c;
}

Catch::Detail::Approx about(double depth) { return Catch::Detail::Approx(depth); }

}  // namespace

TEST_CASE("a sheet covers what it surrounds, as deep as its farthest facet there") {
  Sheet s = grid(4);
  CHECK(s.cover({0.5, 3.5, 0.5, 3.5}) == about(1));
  CHECK(s.cover({1, 2, 1, 2}) == about(1));
  s.facets.facets[10].depth.c = 0.75;  // of the square (1, 1)
  CHECK(s.cover({0.5, 3.5, 0.5, 3.5}) == about(0.75));
  CHECK(s.cover({2.5, 3.5, 2.5, 3.5}) == about(1));
}

TEST_CASE("a sheet does not cover what reaches over its border") {
  const Sheet s = grid(4);
  CHECK(s.cover({-0.5, 3.5, 0.5, 3.5}) == none);
  CHECK(s.cover({0, 4, 0, 4}) == none);  // its border may be a hair inside
  CHECK(s.cover({5, 6, 5, 6}) == none);
}

TEST_CASE("a missing facet is a hole") {
  Sheet s = grid(4);
  s.facets.facets.erase(s.facets.facets.begin() + 10);
  CHECK(s.cover({0.5, 3.5, 0.5, 3.5}) == none);
  CHECK(s.cover({2.5, 3.5, 2.5, 3.5}) == about(1));
}

TEST_CASE("edges at equal places with other corners are no partners") {
  Sheet s;
  const auto a = s.corner(0, 0), b = s.corner(4, 0), c = s.corner(4, 4), d = s.corner(0, 4);
  const auto a2 = s.corner(0, 0);
  s.add(a, b, c);
  s.add(a2, c, d);
  CHECK(s.cover({1, 3, 1, 3}) == none);
  s.facets.facets.pop_back();
  s.add(a, c, d);
  CHECK(s.cover({1, 3, 1, 3}) == about(1));
}

TEST_CASE("a fold covers nothing that its two sides leave open") {
  // Both triangles lie on the same side of their common edge: it runs the same way in both.
  Sheet s;
  const auto a = s.corner(0, 0), b = s.corner(4, 0), c = s.corner(0, 4), d = s.corner(1, 4);
  s.add(a, b, c);
  s.add(a, b, d);
  CHECK(s.cover({0.5, 3.5, -1, 1}) == none);
}

TEST_CASE("a sheet with a facet of unknown depth hides nothing, whatever the order") {
  for (const std::size_t unknown : {10u, 11u}) {  // both of the square (1, 1)
    Sheet s = grid(4);
    s.facets.facets[unknown].depth = {};
    CHECK(s.cover({0.5, 3.5, 0.5, 3.5}) == none);
  }
  // A depth that overflows must be such a one: the least of several could lose a NaN.
  const Case c = wall_with_unknown_plane();
  const std::vector<bool> expected = oracle_visible(c.arrays, c.view);
  CHECK(ids_of(expected).size() == c.arrays.triangles.size());
  CHECK(engine_visible(c) == expected);
}

TEST_CASE("of two sheets the nearer one hides more, with the other behind it or not") {
  Sheet near = grid(4, 2);
  const Sheet far = grid(4, 1);
  for (Facet f : far.facets.facets) {
    for (auto& p : f.points) p += 100;
    near.facets.facets.push_back(f);
  }
  CHECK(near.cover({0.5, 3.5, 0.5, 3.5}) == about(2));
  near.facets.facets.erase(near.facets.facets.begin() + 10);
  CHECK(near.cover({0.5, 3.5, 0.5, 3.5}) == about(1));
}

}  // namespace provis::test
