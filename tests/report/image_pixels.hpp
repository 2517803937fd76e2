#pragma once
// Single pixels of a picture.

#include <array>

#include "provis/draw.hpp"

namespace provis {

using Rgb = std::array<int, 3>;

inline Rgb pixel(const Image& image, int column, int row) {
  const std::size_t at = static_cast<std::size_t>(row * image.width + column) * 3;
  return {image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
}

}  // namespace provis
