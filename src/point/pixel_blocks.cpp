#include "src/point/pixel_blocks.hpp"

#include <algorithm>

namespace provis {
namespace {

double between(double lo, double hi, double share) {
  return std::clamp(lo * (1 - share) + hi * share, lo, hi);
}

}  // namespace

std::vector<double> pixel_borders(double lo, double hi, int n) {
  std::vector<double> borders{lo};
  for (int k = 1; k < n; ++k)
    if (const double b = between(lo, hi, static_cast<double>(k) / n); b > borders.back() && b < hi)
      borders.push_back(b);
  borders.push_back(hi);
  return borders;
}

std::vector<double> sample_coordinates(double lo, double hi, std::size_t n) {
  std::vector<double> at;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = between(lo, hi, (static_cast<double>(k) + 0.5) / static_cast<double>(n));
    at.push_back(at.empty() ? x : std::max(x, at.back()));
  }
  return at;
}

std::pair<GridBox, GridBox> halves(const GridBox& box) {
  GridBox a = box, b = box;
  if (box.width() >= box.height())
    a.x1 = b.x0 = box.x0 + box.width() / 2;
  else
    a.y1 = b.y0 = box.y0 + box.height() / 2;
  return {a, b};
}

}  // namespace provis
