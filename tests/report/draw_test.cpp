// Five triangles whose every pixel is known. The expected bytes were worked out from the formulas of
// src/report/README.md by a separate program, not by this one.

#include "provis/draw.hpp"

#include <png.h>

#include <array>
#include <catch2/catch.hpp>

#include "provis/error.hpp"
#include "tests/report/image_pixels.hpp"
#include "tests/scene/files.hpp"

using namespace provis;

namespace {

const Rgb background = {232, 232, 232};

Scene scene_of(std::vector<std::array<Vec3d, 3>> triangles, std::vector<std::uint8_t> flags) {
  SceneArrays arrays;
  for (const auto& corners : triangles) {
    const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
    arrays.vertices.insert(arrays.vertices.end(), corners.begin(), corners.end());
    arrays.triangles.push_back({first, first + 1, first + 2});
  }
  arrays.triangle_flags = std::move(flags);
  return Scene(std::move(arrays));
}

// 0 fills the left half at distance 2. 1 fills everything at distance 4. 2 is see-through and fills the upper
// right quarter at distance 1. 3 is a floor 0.4 below the eye that reaches behind it. 4 lies behind all.
Scene five_triangles() {
  return scene_of({{Vec3d{-20, -20, -2}, {0, -20, -2}, {0, 20, -2}},
                   {Vec3d{-90, -90, -4}, {90, -90, -4}, {0, 90, -4}},
                   {Vec3d{0, 0, -1}, {9, 0, -1}, {0, 9, -1}},
                   {Vec3d{-30, -0.4, 30}, {30, -0.4, 30}, {0, -0.4, -60}},
                   {Vec3d{-90, -90, -8}, {90, -90, -8}, {0, 90, -8}}},
                  {0, 0, PrimitiveFlag::see_through, 0, 0});
}

VisibleSet seen(std::vector<Status> status) {
  VisibleSet set;
  set.status = std::move(status);
  return set;
}

VisibleSet first_four() {
  return seen({Status::visible, Status::visible, Status::visible, Status::visible, Status::hidden});
}

PointView square_view() {
  PointView view;
  view.frames = {Frame{}};
  return view;
}

}  // namespace

TEST_CASE("the five triangles have the documented colours") {
  const Image image = draw_view(five_triangles(), first_four(), square_view(), 0, 8, 8);
  REQUIRE(image.rgb.size() == 8 * 8 * 3);
  CHECK(pixel(image, 0, 0) == Rgb{90, 157, 200});   // 0
  CHECK(pixel(image, 3, 3) == Rgb{105, 183, 233});  // 0
  CHECK(pixel(image, 3, 4) == Rgb{105, 183, 233});  // 0 before the far floor
  CHECK(pixel(image, 7, 0) == Rgb{174, 116, 67});   // 1 through 2
  CHECK(pixel(image, 4, 3) == Rgb{203, 136, 78});   // 1 through 2
  CHECK(pixel(image, 4, 4) == Rgb{49, 162, 74});    // the far floor, before 1
  CHECK(pixel(image, 5, 5) == Rgb{55, 183, 83});    // the floor
  CHECK(pixel(image, 0, 7) == Rgb{61, 205, 93});    // the floor, before 0
  CHECK(pixel(image, 7, 7) == Rgb{61, 205, 93});
}

TEST_CASE("only what the set calls visible is drawn") {
  const auto only_last =
      seen({Status::hidden, Status::hidden, Status::undecided, Status::hidden, Status::visible});
  const Image image = draw_view(five_triangles(), only_last, square_view(), 0, 8, 8);
  const Image nothing =
      draw_view(five_triangles(), seen(std::vector<Status>(5, Status::hidden)), square_view(), 0, 8, 8);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column) {
      CHECK(pixel(image, column, row) != background);
      CHECK(pixel(nothing, column, row) == background);
    }
  }
}

TEST_CASE("a triangle behind the eye is not seen through its own plane") {
  const Scene scene = scene_of({{Vec3d{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}}}, {0});
  for (Projection projection : {Projection::pinhole, Projection::parallel}) {
    PointView view = square_view();
    view.projection = projection;
    CHECK(pixel(draw_view(scene, seen({Status::visible}), view, 0, 3, 3), 1, 1) == background);
  }
}

TEST_CASE("a parallel projection sees by window coordinates, the nearer first") {
  const Scene scene = scene_of({{Vec3d{-1, -1, -50}, {1, -1, -50}, {-1, 1, -50}},
                                {Vec3d{-9, -9, -60}, {9, -9, -60}, {0, 9, -60}},
                                {Vec3d{-1, -1, 5}, {1, -1, 5}, {-1, 1, 5}}},
                               {0, 0, 0});
  PointView view = square_view();
  view.projection = Projection::parallel;
  const Image image =
      draw_view(scene, seen({Status::visible, Status::visible, Status::visible}), view, 0, 4, 4);
  CHECK(pixel(image, 0, 3) == Rgb{106, 184, 235});  // 0, straight on: the plain colour of id 0
  CHECK(pixel(image, 3, 0) == Rgb{204, 167, 31});   // 1, the plain colour of id 1
}

TEST_CASE("coincident triangles: the smaller id is on top, whatever the number of tasks") {
  const std::array<Vec3d, 3> t = {Vec3d{-9, -9, -1}, {9, -9, -1}, {0, 9, -1}};
  const Scene scene = scene_of({t, t}, {0, 0});
  const Image both = draw_view(scene, seen({Status::visible, Status::visible}), square_view(), 0, 64, 64);
  const Image first = draw_view(scene, seen({Status::visible, Status::hidden}), square_view(), 0, 64, 64);
  CHECK(both.rgb == first.rgb);
}

TEST_CASE("six frames are laid out three by two") {
  const Scene scene = scene_of({{Vec3d{5, -4, -4}, {5, 4, -4}, {5, 0, 4}}}, {0});
  const Image image = draw_frames(scene, seen({Status::visible}), omni({0, 0, 0}), 30, 20);
  REQUIRE(image.width == 30);
  CHECK(pixel(image, 5, 5) != background);   // +x
  CHECK(pixel(image, 15, 5) == background);  // -x
  CHECK(pixel(image, 25, 15) == background);
}

TEST_CASE("statuses are told apart from the eye") {
  const std::array<Vec3d, 3> left = {Vec3d{-9, -9, -2}, {0, -9, -2}, {0, 9, -2}},
                             right = {Vec3d{0, -9, -2}, {9, -9, -2}, {0, 9, -2}},
                             behind = {Vec3d{0, -99, -4}, {99, -99, -4}, {0, 99, -4}};
  const Scene scene = scene_of({left, right, behind}, {0, 0, 0});
  const auto at = [&](const std::vector<Status>& statuses, int column) {
    return pixel(draw_frames(scene, seen(statuses), square_view(), 2, 1, draw_statuses), column, 0);
  };
  const auto v = Status::visible, u = Status::undecided, h = Status::hidden;
  // The rays of two pixels, (-1/2, 0, -1) and (1/2, 0, -1), meet the planes at a cosine of 2 / sqrt 5: 0.958
  // of the colour.
  CHECK(at({h, h, v}, 0) == Rgb{215, 218, 222});  // one hidden layer: 15 % of grey-blue
  CHECK(at({v, h, h}, 0) == Rgb{242, 183, 103});  // 80 % of orange over background
  CHECK(at({h, v, h}, 1) == Rgb{238, 180, 101});  // over one hidden layer
  CHECK(at({h, v, u}, 1) == Rgb{108, 159, 104});  // undecided behind it: 60 % of green over that
  CHECK(at({h, u, v}, 1) == Rgb{108, 159, 104});  // and before it
}

TEST_CASE("pictures that cannot be are refused") {
  const auto refuse = [](int width, int height, int frame, const VisibleSet& set) {
    CHECK_THROWS_AS(draw_view(five_triangles(), set, square_view(), frame, width, height), Error);
  };
  refuse(0, 8, 0, first_four());
  refuse(8, 20000, 0, first_four());
  refuse(8, 8, 1, first_four());
  refuse(8, 8, 0, seen({Status::visible}));
}

TEST_CASE("a PNG file holds the picture") {
  const TempFolder directory;
  const Image image = draw_view(five_triangles(), first_four(), square_view(), 0, 13, 7);
  write_png(image, directory.path() / "view.png");

  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&header, (directory.path() / "view.png").c_str()) != 0);
  header.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(header));
  REQUIRE(png_image_finish_read(&header, nullptr, rgb.data(), 0, nullptr) != 0);
  CHECK(header.width == 13);
  CHECK(header.height == 7);
  CHECK(rgb == image.rgb);
}

TEST_CASE("a PNG file that cannot be written is an output error") {
  const TempFolder directory;
  const Image image{1, 1, {1, 2, 3}};
  try {
    write_png(image, directory.path() / "no/view.png");
    FAIL("was written");
  } catch (const Error& error) {
    CHECK(error.code() == Error::Code::output);
  }
}
