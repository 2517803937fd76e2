// A row of pixels over time: every pixel of the picture is known. The colours were worked out from the
// formulas of src/report/README.md by a separate program, not by this one.

#include <array>
#include <catch2/catch.hpp>

#include "provis/draw.hpp"
#include "provis/error.hpp"
#include "tests/report/image_pixels.hpp"

using namespace provis;

namespace {

const Rgb background = {232, 232, 232}, of_0 = {106, 184, 235}, of_1 = {204, 167, 31},
          of_both = {155, 175, 133};

PixelSights sights(std::vector<Sight> list) { return {0, 0, 0, std::move(list)}; }

}  // namespace

TEST_CASE("over time: a picture's row shows what is seen at its middle, by exact times") {
  const Image image = draw_over_time({sights({{"0/1", "1/8", {0}}, {"1/8", "5/8", {1}}, {"5/8", "1/1", {}}}),
                                      sights({{"0/1", "1/1", {0, 1}}})},
                                     2, 4);
  // Moments 1/8, 3/8, 5/8, 7/8: at an event the later sight is shown.
  CHECK(pixel(image, 0, 0) == of_1);
  CHECK(pixel(image, 0, 1) == of_1);
  CHECK(pixel(image, 0, 2) == background);
  CHECK(pixel(image, 0, 3) == background);
  for (int y = 0; y < 4; ++y) CHECK(pixel(image, 1, y) == of_both);
}

TEST_CASE("over time: an event a hair after a moment belongs to the next row") {
  // 1/8 + 10^-40, which no double tells from 1/8.
  const std::string late =
      "1250000000000000000000000000000000000001/10000000000000000000000000000000000000000";
  const Image image = draw_over_time({sights({{"0/1", late, {0}}, {late, "1/1", {1}}})}, 1, 4);
  CHECK(pixel(image, 0, 0) == of_0);
  CHECK(pixel(image, 0, 1) == of_1);
}

TEST_CASE("over time: columns are spread over the width, and a sight between two moments leaves no trace") {
  const Image image =
      draw_over_time({sights({{"0/1", "1/1", {0}}}),
                      sights({{"0/1", "1/3", {1}}, {"1/3", "2/5", {0}}, {"2/5", "1/1", {1}}})},
                     5, 2);
  for (int y = 0; y < 2; ++y) {
    for (const int x : {0, 1}) CHECK(pixel(image, x, y) == of_0);
    for (const int x : {2, 3, 4}) CHECK(pixel(image, x, y) == of_1);
  }
}

TEST_CASE("over time: no pixels and no size are refused") {
  CHECK_THROWS_AS(draw_over_time({}, 1, 1), Error);
  CHECK_THROWS_AS(draw_over_time({sights({{"0/1", "1/1", {}}})}, 0, 1), Error);
  CHECK_THROWS_AS(draw_over_time({sights({{"0/1", "1/1", {}}})}, 1, 16385), Error);
}
