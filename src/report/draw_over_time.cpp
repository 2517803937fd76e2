// One row of pixels over time. Between two events a pixel shows one set, so a picture's row is decided by
// comparing its moment with exact times.

#include "provis/draw.hpp"
#include "provis/error.hpp"
#include "src/report/colors.hpp"
#include "src/report/picture.hpp"
#include "src/segment/exact_event.hpp"

namespace provis {

namespace {

/// No light falls on it: the same primitive has the same colour wherever it is seen.
Color color_of(const std::vector<PrimitiveId>& visible) {
  if (visible.empty()) return background_color;
  Color sum{};
  for (const PrimitiveId id : visible) {
    const Color color = id_color(id);
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += color[c];
  }
  return scaled(sum, 1 / static_cast<double>(visible.size()));
}

std::vector<Color> column_of(const PixelSights& pixel, int height) {
  std::vector<Color> column(static_cast<std::size_t>(height), background_color);
  auto row = column.begin();
  for (const Sight& s : pixel.sights) {
    const auto end = column.begin() + moments_before(s.to, height);
    if (row < end) row = std::fill_n(row, end - row, color_of(s.visible));
  }
  return column;
}

}  // namespace

Image draw_over_time(const std::vector<PixelSights>& pixels, int width, int height) {
  if (pixels.empty()) throw Error(Error::Code::usage, "picture", "there is no pixel to draw");
  Image image = blank_image(width, height);
  const auto pixel_of = [&](int x) {
    return (2 * static_cast<std::size_t>(x) + 1) * pixels.size() / (2 * static_cast<std::size_t>(width));
  };
  std::vector<Color> column;
  for (int x = 0; x < width; ++x) {
    if (x == 0 || pixel_of(x) != pixel_of(x - 1)) column = column_of(pixels[pixel_of(x)], height);
    for (int y = 0; y < height; ++y) set_pixel(image, x, y, column[static_cast<std::size_t>(y)]);
  }
  return image;
}

}  // namespace provis
