#pragma once
// The pixels and the regular rays of a frame, and blocks of them.

#include <cstddef>
#include <utility>
#include <vector>

namespace provis {

/// Columns [x0, x1) and rows [y0, y1) of a grid.
struct GridBox {
  std::size_t x0 = 0, x1 = 0, y0 = 0, y1 = 0;

  std::size_t width() const { return x1 - x0; }
  std::size_t height() const { return y1 - y0; }
  bool within(std::size_t side) const { return width() <= side && height() <= side; }
};

/// The borders of n pixels between lo and hi: lo, hi and the float64 numbers about the regular ones, strictly
/// ascending. Where there are not enough numbers there are fewer pixels.
std::vector<double> pixel_borders(double lo, double hi, int n);

/// The middles of n equal parts between lo and hi, rounded to float64 numbers; never outside, never
/// descending.
std::vector<double> sample_coordinates(double lo, double hi, std::size_t n);

/// Halves a grid along its longer side.
std::pair<GridBox, GridBox> halves(const GridBox& box);

}  // namespace provis
