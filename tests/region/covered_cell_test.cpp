// A flat cell has a viewpoint unless occluders cover all of it.

#include <catch2/catch.hpp>
#include <cmath>

#include "provis/error.hpp"
#include "src/region/covered_cell.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

const ViewCell square{{0, 0, 2}, {1, 1, 2}, {}}, edge{{0, 0, 2}, {1, 0, 2}, {}};

using Corners = std::array<Vec3d, 3>;

bool covered(const ViewCell& cell, const std::vector<Corners>& triangles, std::uint8_t flags = 0) {
  SceneArrays arrays;
  for (const Corners& t : triangles) add_triangle(arrays, t[0], t[1], t[2], flags);
  return lies_on_occluders(Scene(arrays), cell);
}

const double below_one = std::nextafter(1.0, 0.0);

}  // namespace

TEST_CASE("a rectangle that occluders cover has no viewpoint") {
  const Corners all{{{-4, -4, 2}, {8, -4, 2}, {-4, 8, 2}}};
  CHECK(covered(square, {all}));
  CHECK(covered(square, {all}, single_sided));
  CHECK_FALSE(covered(square, {all}, see_through));
  CHECK_FALSE(covered(square, {}));
  CHECK_FALSE(covered(square, {{{{-4, -4, 2}, {8, -4, 2}, {-4, 8, 2.5}}}}));
  CHECK_FALSE(covered({{0, 0, 0}, {1, 1, 2}, {}}, {all}));
  const Corners lower{{{0, 0, 2}, {1, 0, 2}, {1, 1, 2}}}, upper{{{0, 0, 2}, {1, 1, 2}, {0, 1, 2}}};
  CHECK(covered(square, {lower, upper}));
  CHECK_FALSE(covered(square, {lower}));
  CHECK_FALSE(covered(square, {lower, {{{0, 0, 2}, {below_one, 1, 2}, {0, 1, 2}}}}));
  CHECK_FALSE(covered(square, {lower, {{{0, 0, 2}, {1, 1, 2}, {0, below_one, 2}}}}));
}

TEST_CASE("a segment that occluders cover has no viewpoint, in whatever planes they lie") {
  const Corners first{{{-1, 0, 2}, {0.5, 0, 2}, {0, 5, 2}}}, second{{{0.5, 0, 2}, {0, -1, 3}, {2, 0, 2}}};
  CHECK(covered(edge, {first, second}));
  CHECK(covered(edge, {second, first}));
  CHECK_FALSE(covered(edge, {first}));
  CHECK_FALSE(covered(edge, {second}));
  CHECK_FALSE(covered(edge, {first, {{{std::nextafter(0.5, 1), 0, 2}, {0, -1, 3}, {2, 0, 2}}}}));
  CHECK_FALSE(covered(edge, {{{{-1, 1, 2}, {2, 1, 2}, {0, 5, 2}}}}));
  CHECK_FALSE(covered(edge, {{{{0.5, -1, 1}, {0.5, 1, 1}, {0.5, 0, 4}}}}));  // crossed in a point
}

TEST_CASE("a cell without a viewpoint is refused by every method, and a slit is enough to be answered") {
  SceneArrays arrays;
  add_triangle(arrays, {-4, -4, 2}, {8, -4, 2}, {-4, 8, 2});
  add_triangle(arrays, {-1, -1, 9}, {1, -1, 9}, {0, 1, 9});
  for (const CellMethod method : {CellMethod::bounds, CellMethod::lower, CellMethod::cos}) {
    try {
      visible_from_cell(Scene(arrays), square, small_options(method, 2, 4), one_thread());
      FAIL("was answered");
    } catch (const Error& e) {
      CHECK(e.code() == Error::Code::unsupported);
    }
  }
  SceneArrays slit;
  const double a = 0.3, b = std::nextafter(a, 1);
  add_triangle(slit, {-1, -1, 2}, {a, -1, 2}, {-1, 50, 2});
  add_triangle(slit, {a, -1, 2}, {a, 50, 2}, {-1, 50, 2});
  add_triangle(slit, {b, -1, 2}, {3, -1, 2}, {b, 50, 2});
  add_triangle(slit, {3, -1, 2}, {3, 50, 2}, {b, 50, 2});
  add_triangle(slit, {-1, -1, 9}, {1, -1, 9}, {0, 1, 9});
  for (const CellMethod method : {CellMethod::bounds, CellMethod::lower, CellMethod::cos}) {
    const CellSet set = visible_from_cell(Scene(slit), square, small_options(method, 2, 4), one_thread());
    CHECK(set.set.status[4] != Status::hidden);
  }
}

TEST_CASE("what lies farther from the cell than numbers reach is aimed at by no ray") {
  SceneArrays arrays;
  const double far = 1.2e308, size = 1e307;
  add_triangle(arrays, {far, -size, -size}, {far, size, -size}, {far, 0, size});
  const ViewCell cell{{-far, 0, 0}, {-far / 2, size, size}, {}};
  CellOptions options = small_options(CellMethod::bounds, 2, 4);
  options.rays = 16;
  options.viewpoints = 0;
  const CellSet set = visible_from_cell(Scene(arrays), cell, options, one_thread());
  CHECK(set.set.status[0] != Status::hidden);
}

}  // namespace provis::test
