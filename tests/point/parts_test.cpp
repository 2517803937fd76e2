// What float64 rules out before anything is made of a triangle: never anything that is visible.

#include <catch2/catch.hpp>

#include <set>

#include "provis/error.hpp"
#include "provis/point.hpp"
#include "src/point/parts.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"

namespace provis::test {
namespace {

Parts parts_of(const Scene& scene, const PointView& view, std::size_t frame = 0) {
  const ViewGeometry g = make_geometry(view.eye, view.frames[frame], view.projection == Projection::parallel);
  return make_parts(scene, g, view.frames[frame].window, {});
}

/// A square across the view at distance z, of half width w, in n x n squares of two triangles.
void add_wall(SceneArrays& s, double z, double w, int n) {
  const auto first = static_cast<std::uint32_t>(s.vertices.size());
  const auto at = [&](int k) { return w * (2.0 * k / n - 1); };
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) s.vertices.push_back({at(i), at(j), -z});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const auto id = [&](int a, int b) {
        return first + static_cast<std::uint32_t>((j + b) * (n + 1) + (i + a));
      };
      s.triangles.push_back({id(0, 0), id(1, 0), id(1, 1)});
      s.triangles.push_back({id(0, 0), id(1, 1), id(0, 1)});
    }
  s.triangle_flags.assign(s.triangles.size(), 0);
}

/// Different triangles from the given one on.
std::size_t members(const Parts& parts, PrimitiveId from = 0) {
  std::set<PrimitiveId> ids;
  for (std::size_t p = 0; p < parts.size(); ++p)
    for (const PrimitiveId t : parts.members(p))
      if (t >= from) ids.insert(t);
  return ids.size();
}

}  // namespace

TEST_CASE("the parts fill the window, and every visible triangle is in one of them") {
  for (const std::uint64_t seed : seeds(20)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const Scene scene(c.arrays);
    std::vector<bool> kept(scene.triangles().size(), false);
    for (std::size_t f = 0; f < c.view.frames.size(); ++f) {
      const Parts parts = parts_of(scene, c.view, f);
      const Window& w = c.view.frames[f].window;
      const Window first = parts.window(0), last = parts.window(parts.size() - 1);
      REQUIRE((first.x0 == w.x0 && first.y0 == w.y0 && last.x1 == w.x1 && last.y1 == w.y1));
      for (std::size_t p = 0; p < parts.size(); ++p) {
        if (p > 0 && parts.window(p).y0 == parts.window(p - 1).y0)
          REQUIRE(parts.window(p).x0 == parts.window(p - 1).x1);
        for (const PrimitiveId t : parts.members(p)) kept[t] = true;
      }
    }
    const std::vector<bool> visible = oracle_visible(c.arrays, c.view);
    for (std::size_t t = 0; t < kept.size(); ++t) REQUIRE((kept[t] || !visible[t]));
  }
}

TEST_CASE("what lies behind a wall is ruled out, but not what stands beside or before it") {
  SceneArrays s;
  add_wall(s, 10, 3, 1);  // covers the middle, but for cells on its diagonal
  add_wall(s, 20, 5, 20);
  const Scene scene(s);
  const PointView view = look_at({.eye = {0, 0, 0}, .direction = {0, 0, -1}, .width = 1, .height = 1});
  CHECK(members(parts_of(scene, view), 2) < 300);  // of 800

  s.triangle_flags[0] = s.triangle_flags[1] = see_through;
  CHECK(members(parts_of(Scene(s), view), 2) == 800);

  SceneArrays wide;
  add_wall(wide, 10, 3, 1);
  add_wall(wide, 20, 11, 20);  // reaches out around it, beyond the window
  const std::size_t left = members(parts_of(Scene(wide), view), 2);
  CHECK((left > 400 && left < 700));
}

TEST_CASE("parts are made whatever the window: a few ulps, or one far from the eye's direction") {
  SceneArrays s;
  add_wall(s, 10, 3, 4);
  const Scene scene(s);
  PointView view = look_at({.eye = {0, 0, 0}, .direction = {0, 0, -1}});
  view.frames[0].window = {0.125, 0.125 + 0x1p-52, -0.5, 0.5};
  CHECK(visible_from_point(scene, view).with(Status::visible).size() > 0);
  view.frames[0].window = {0x1p20, 0x1p20 + 1, -0.5, 0.5};
  CHECK(members(parts_of(scene, view)) == 0);
  std::atomic<bool> cancel = true;
  Context context;
  context.cancel = &cancel;
  CHECK_THROWS_AS(make_parts(scene, make_geometry({}, view.frames[0], false), {-1, 1, -1, 1}, context),
                  Error);
}

}  // namespace provis::test
