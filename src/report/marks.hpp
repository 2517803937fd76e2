#pragma once
// Lines and discs on a finished picture. Coordinates are fractional pixels; what is outside is cut off.

#include <array>
#include <vector>

#include "provis/draw.hpp"
#include "src/report/colors.hpp"

namespace provis {

using PixelPoint = std::array<double, 2>;

/// Indices (row * width + column) of the pixels under the segment, as far as they lie in the picture.
std::vector<std::size_t> pixels_under(const PixelPoint& from, const PixelPoint& to, int width, int height);

/// Two to three pixels wide.
void draw_line(Image& image, const PixelPoint& from, const PixelPoint& to, const Color& color);

/// Every pixel whose centre lies between the two radii.
void draw_ring(Image& image, const PixelPoint& center, double inner, double outer, const Color& color);

}  // namespace provis
