// The descent into a window that is much wider, or higher, than what is seen in it.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/point/answers.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

/// 200 boards side by side that overlap a little, and behind each seam a triangle that two of them hide
/// together. They reach over all of the window one way, so that halving it that way separates nothing.
Case fence() {
  Case c;
  constexpr int boards = 200;
  constexpr double width = 2.0 / boards;
  for (int i = 0; i < boards; ++i) {
    const double z = -1 - 0.001 * (i % 3), x0 = -1 + width * (i - 0.2), x1 = -1 + width * (i + 1.2);
    add_triangle(c.arrays, {x0, -3, z}, {x1, -3, z}, {x1, 3, z});
    add_triangle(c.arrays, {x0, -3, z}, {x1, 3, z}, {x0, 3, z});
    if (i + 1 == boards) break;
    const auto behind = [&](double at, double y) { return Vec3d{1.2 * (-1 + width * (i + at)), y, -1.2}; };
    add_triangle(c.arrays, behind(0.3, -2), behind(1.5, -2), behind(1.2, 2));
  }
  return c;
}

VisibleSet through(const Case& c, const Window& window, PointEngine engine) {
  PointView view = c.view;
  Frame f;
  f.window = window;
  view.frames = {f};
  PointOptions options;
  options.engine = engine;
  options.pixels = {16, 16};
  return visible_from_point(Scene(c.arrays), view, options);
}

}  // namespace

// Strictly alternate halvings would need a rectangle for each strip of the other axis: 2^20 of them.
TEST_CASE("a very wide or high window takes hardly more rectangles than one that fits") {
  for (const PointEngine engine : {PointEngine::fast, PointEngine::paper}) {
    Case c = fence();
    const auto expected = through(c, {-2, 2, -1, 1}, engine);
    CHECK(expected.with(Status::visible).size() == 400);
    const double far = 0x1p20;
    const auto wide = through(c, {-far, far, -1, 1}, engine);
    CHECK(visible_flags(wide) == visible_flags(expected));
    CHECK(wide.stats.leaves < 20 * expected.stats.leaves);
    for (Vec3d& v : c.arrays.vertices) v = {v.y, v.x, v.z};
    const auto high = through(c, {-1, 1, -far, far}, engine);
    CHECK(visible_flags(high) == visible_flags(expected));
    CHECK(high.stats.leaves < 20 * expected.stats.leaves);
  }
}

}  // namespace provis::test
