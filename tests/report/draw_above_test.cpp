// The bird's-eye picture of a small scene whose map from units to pixels is known.

#include <array>
#include <catch2/catch.hpp>

#include "provis/draw.hpp"
#include "provis/error.hpp"
#include "tests/report/image_pixels.hpp"
#include "tests/support/triangles.hpp"

using namespace provis;

namespace {

// The scene spans 24 units from left to right and the picture 264 pixels with 10 % to spare: 10 pixels a
// unit, the middle (12 right, 3 behind) in the picture's middle.
constexpr int width = 264, height = 160;

Rgb at(const Image& image, double right, double behind) {
  const int column = static_cast<int>(132 + 10 * (right - 12)),
            row = static_cast<int>(80 + 10 * (behind - 3));
  return pixel(image, column, row);
}

// Of height 0 unless said otherwise: 0 visible, 1 hidden, 2 undecided, 3 a hidden roof over 0, 4 a visible
// wall.
Scene plan_scene() {
  SceneArrays arrays;
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    test::add_triangle(arrays, a, b, c);
  };
  add({0, 0, 0}, {4, 0, 0}, {0, 0, -4});
  add({10, 0, 0}, {14, 0, 0}, {10, 0, -4});
  add({20, 0, 0}, {24, 0, 0}, {20, 0, -4});
  add({0, 3, 0}, {4, 3, 0}, {0, 3, -4});
  add({5, 0, 0.05}, {8, 0, 0.05}, {5, 2, 0.05});
  return Scene(std::move(arrays));
}

VisibleSet plan_set() {
  VisibleSet set;
  set.status = {Status::visible, Status::hidden, Status::undecided, Status::hidden, Status::visible};
  return set;
}

// From (12, 1, 10), looking away from everything, so that no ray crosses the triangles.
PointView plan_view() {
  PointView view;
  view.eye = {12, 1, 10};
  view.frames = {Frame{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 1, -1, 1}}};
  return view;
}

const Rgb background = {232, 232, 232}, eye = {20, 40, 160}, wall = {150, 44, 0};

}  // namespace

TEST_CASE("statuses are told apart from above") {
  const Image image = draw_above(plan_scene(), plan_set(), plan_view(), width, height);
  CHECK(at(image, 9, -3) == background);
  CHECK(at(image, 11, -1) == Rgb{215, 218, 222});  // one hidden layer: 15 % of grey-blue
  CHECK(at(image, 21, -1) == Rgb{62, 166, 134});   // 80 % of green
  // Visible, on top of its hidden roof: 80 % of the warm colour over one hidden layer.
  CHECK(at(image, 1, -1) == Rgb{247, 186, 104});
  CHECK(at(image, 6, 0.05) == wall);
  CHECK(at(image, 12, 10) == eye);
}

TEST_CASE("the window's borders run from the viewpoint in the picture") {
  const Image image = draw_above(plan_scene(), plan_set(), plan_view(), width, height);
  CHECK(at(image, 12.55, 10.55) == eye);
  CHECK(at(image, 11.25, 10.75) == eye);
  CHECK(at(image, 12, 7) == background);
}

TEST_CASE("without a window there is a circle") {
  PointView view = omni({12, 1, 10});
  for (Frame& frame : view.frames) frame.up = {0, 1, 0};
  const Image image = draw_above(plan_scene(), plan_set(), view, width, height);
  CHECK(at(image, 12, 10) == eye);
  CHECK(at(image, 12 + 0.9 + 0.1, 10) == eye);
  CHECK(at(image, 12 - 0.95 - 0.05, 10) == eye);
}

TEST_CASE("up decides the axis, and nothing is mirrored") {
  PointView view = plan_view();
  view.frames = {Frame{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {-1, 1, -1, 1}}};
  const Image from_z = draw_above(plan_scene(), plan_set(), view, width, height);
  CHECK(from_z.rgb != draw_above(plan_scene(), plan_set(), plan_view(), width, height).rgb);
}

TEST_CASE("an empty scene is a viewpoint on an empty plan") {
  const Image image = draw_above(Scene(), VisibleSet{}, plan_view(), 20, 20);
  CHECK(image.rgb.size() == 20 * 20 * 3);
  CHECK_THROWS_AS(draw_above(Scene(), VisibleSet{}, PointView{}, 20, 20), Error);
}
