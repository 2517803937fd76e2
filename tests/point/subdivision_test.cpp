// The planar subdivision: what is seen somewhere is the set, and nothing of the window is lost.

#include <catch2/catch.hpp>

#include <gmpxx.h>

#include "tests/point/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {
namespace {

VisibleSet with_subdivision(const Scene& scene, const PointView& view) {
  PointOptions options;
  options.subdivision = true;
  return visible_from_point(scene, view, options);
}

mpq_class window_area(const PointView& view) {
  mpq_class sum = 0;
  for (const Frame& f : view.frames)
    sum +=
        (mpq_class(f.window.x1) - mpq_class(f.window.x0)) * (mpq_class(f.window.y1) - mpq_class(f.window.y0));
  return sum;
}

mpq_class cell_area(const VisibleSet& set) {
  mpq_class sum = 0;
  for (const SubdivisionCell& cell : set.subdivision) sum += mpq_class(cell.area);
  return sum;
}

Scene triangles(std::vector<Vec3d> corners) {
  SceneArrays a;
  a.vertices = std::move(corners);
  for (std::uint32_t v = 0; v + 2 < a.vertices.size(); v += 3) a.triangles.push_back({v, v + 1, v + 2});
  a.triangle_flags.assign(a.triangles.size(), 0);
  return Scene(std::move(a));
}

}  // namespace

TEST_CASE("the cells hold the visible set and fill the window exactly") {
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const VisibleSet set = with_subdivision(Scene(c.arrays), c.view);
    std::vector<bool> seen(set.status.size(), false);
    for (const SubdivisionCell& cell : set.subdivision) {
      REQUIRE(cell.corners.size() >= 3);
      REQUIRE(sgn(mpq_class(cell.area)) > 0);
      for (const PrimitiveId id : cell.visible) seen[id] = true;
    }
    REQUIRE(seen == visible_flags(set));
    REQUIRE(seen == engine_visible(c));
    REQUIRE(cell_area(set) == window_area(c.view));
  }
}

TEST_CASE("the six frames of the whole sphere have area 24") {
  const Scene scene = triangles({{-1, -1, -2}, {1, -1, -2}, {0, 1, -2}});
  CHECK(cell_area(with_subdivision(scene, omni({0, 0, 0}))) == 24);
}

TEST_CASE("a triangle before the background has the area of its projection") {
  // At distance 2 a right triangle with legs 2 covers half of a unit square of the window.
  const Scene scene = triangles({{-1, -1, -2}, {1, -1, -2}, {-1, 1, -2}});
  const VisibleSet set = with_subdivision(scene, {{0, 0, 0}, Projection::pinhole, {Frame{}}});
  mpq_class seen = 0, background = 0;
  for (const SubdivisionCell& cell : set.subdivision) {
    REQUIRE(cell.visible.size() <= 1);
    (cell.visible.empty() ? background : seen) += mpq_class(cell.area);
  }
  CHECK(seen == mpq_class(1, 2));
  CHECK(background == mpq_class(7, 2));
}

TEST_CASE("coincident triangles share their cells, and a see-through one before them joins in") {
  SceneArrays a = triangles({{-1, -1, -2},
                             {1, -1, -2},
                             {-1, 1, -2},  //
                             {-1, -1, -2},
                             {-1, 1, -2},
                             {1, -1, -2},  //
                             {-.5, -.5, -1},
                             {.5, -.5, -1},
                             {-.5, .5, -1}})
                      .arrays();
  a.triangle_flags[2] = see_through;
  const VisibleSet set = with_subdivision(Scene(a), {{0, 0, 0}, Projection::pinhole, {Frame{}}});
  mpq_class all_three = 0;
  for (const SubdivisionCell& cell : set.subdivision)
    if (cell.visible == std::vector<PrimitiveId>{0, 1, 2}) all_three += mpq_class(cell.area);
  CHECK(all_three == mpq_class(1, 2));
}

}  // namespace provis::test
