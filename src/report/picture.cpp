#include "src/report/picture.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "provis/error.hpp"

namespace provis {

Image blank_image(int width, int height) {
  if (width < 1 || height < 1 || width > max_image_side || height > max_image_side) {
    throw Error(
        Error::Code::usage, "picture",
        fmt::format("size {}x{} is outside 1x1 to {}x{}", width, height, max_image_side, max_image_side));
  }
  Image image{width, height, {}};
  const auto color = bytes(background_color);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  image.rgb.reserve(pixels * 3);
  for (std::size_t i = 0; i < pixels; ++i) image.rgb.insert(image.rgb.end(), color.begin(), color.end());
  return image;
}

void set_pixel(Image& image, int column, int row, const Color& color) {
  const auto rounded = bytes(color);
  const std::ptrdiff_t at = (static_cast<std::ptrdiff_t>(row) * image.width + column) * 3;
  std::copy(rounded.begin(), rounded.end(), image.rgb.begin() + at);
}

void paste(Image& image, const Image& part, int left, int top) {
  const int columns = std::min(part.width, image.width - left);
  for (int row = 0; row < part.height && top + row < image.height && columns > 0; ++row) {
    const auto from = part.rgb.begin() + static_cast<std::ptrdiff_t>(row) * part.width * 3;
    const std::ptrdiff_t at = (static_cast<std::ptrdiff_t>(top + row) * image.width + left) * 3;
    std::copy(from, from + static_cast<std::ptrdiff_t>(columns) * 3, image.rgb.begin() + at);
  }
}

void require_match(const Scene& scene, const VisibleSet& set) {
  if (set.status.size() == scene.primitive_count()) return;
  throw Error(Error::Code::usage, "picture",
              fmt::format("the set has {} entries, the scene {} primitives", set.status.size(),
                          scene.primitive_count()));
}

}  // namespace provis
