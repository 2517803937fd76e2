// Views: the camera's vectors, the six frames of the sphere, and what is refused.

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "provis/error.hpp"
#include "provis/view.hpp"

namespace provis {
namespace {

std::string refusal(const PointView& view) {
  try {
    check(view);
  } catch (const Error& e) {
    CHECK(e.code() == Error::Code::usage);
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("an axis-aligned camera has axis-aligned vectors") {
  const PointView v = look_at({.eye = {1, 2, 3},
                               .direction = {0, 0, -5},
                               .up = {0, 2, 0},
                               .fovy_degrees = 90,
                               .width = 200,
                               .height = 100});
  REQUIRE(v.frames.size() == 1);
  const Frame& f = v.frames[0];
  CHECK(f.forward == Vec3d{0, 0, -1});
  CHECK(f.right == Vec3d{1, 0, 0});
  CHECK(f.up == Vec3d{0, 1, 0});
  const double h = std::tan(std::acos(-1.0) / 4);
  CHECK(f.window == Window{-2 * h, 2 * h, -h, h});
}

TEST_CASE("an up vector parallel to the view is replaced") {
  const PointView v = look_at({.eye = {0, 0, 0}, .direction = {0, -1, 0}});
  CHECK(v.frames[0].up == Vec3d{0, 0, -1});
  CHECK(refusal(v) == "");
  CHECK(refusal(look_at({.eye = {0, 0, 0}, .direction = {0, 0, -1}, .up = {0, 0, 1}})) == "");
}

TEST_CASE("directions of any length are normalised without overflow") {
  const PointView v = look_at({.eye = {0, 0, 0}, .direction = {0, 0, -1e300}});
  CHECK(v.frames[0].forward == Vec3d{0, 0, -1});
  CHECK(look_at({.eye = {0, 0, 0}, .direction = {0, 0, -1e-300}}).frames == v.frames);
}

TEST_CASE("cameras that make no sense are refused by name") {
  CHECK_THROWS_WITH(look_at({.eye = {0, 0, 0}, .direction = {0, 0, 0}}), Catch::Contains("direction"));
  CHECK_THROWS_WITH(look_at({.eye = {NAN, 0, 0}}), Catch::Contains("eye"));
  CHECK_THROWS_WITH(look_at({.eye = {0, 0, 0}, .fovy_degrees = 180}), Catch::Contains("fovy"));
  CHECK_THROWS_WITH(look_at({.eye = {0, 0, 0}, .width = 0}), Catch::Contains("size"));
}

TEST_CASE("the six frames of the sphere look along the six axes") {
  const PointView v = omni({1, 2, 3});
  REQUIRE(v.frames.size() == 6);
  Vec3d sum;
  for (const Frame& f : v.frames) {
    sum = sum + f.forward;
    CHECK(dot(f.right, f.up) == 0);
    CHECK(dot(f.right, f.forward) == 0);
    CHECK(dot(f.up, f.forward) == 0);
  }
  CHECK(sum == Vec3d{0, 0, 0});
  CHECK(refusal(v) == "");
}

TEST_CASE("dependent vectors, empty windows and wrong frame counts are refused") {
  PointView v{{0, 0, 0}, Projection::pinhole, {Frame{}}};
  CHECK(refusal(v) == "");
  v.frames[0].up = {2, 0, 0};
  CHECK_THAT(refusal(v), Catch::Contains("linearly dependent"));
  v.frames[0] = Frame{};
  v.frames[0].up = {1e-300, std::numeric_limits<double>::denorm_min(), 0};
  CHECK(refusal(v) == "");
  v.frames[0] = Frame{};
  v.frames[0].window.x1 = v.frames[0].window.x0;
  CHECK_THAT(refusal(v), Catch::Contains("x0 < x1"));
  v.frames[0] = Frame{};
  v.frames[0].window.y1 = INFINITY;
  CHECK_THAT(refusal(v), Catch::Contains("window"));
  v.frames.clear();
  CHECK_THAT(refusal(v), Catch::Contains("frames"));
}

}  // namespace provis
