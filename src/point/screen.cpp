#include "src/point/screen.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace provis {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// A float32 number that is not below the given one, which may be rounded by 2^-40 of itself.
float upper_float(double value) {
  const float f = static_cast<float>(value + std::fabs(value) * 0x1p-22);
  return f == f ? f : infinity;
}

}  // namespace

Screen::Screen(const ViewGeometry& g, const WindowGrid& grid, double unit)
    : projection_(g), window_(grid.window), unit_(std::exp2(std::floor(std::log2(unit)))) {
  const double width = window_.x1 - window_.x0, height = window_.y1 - window_.y0;
  const double narrow = std::min(width, height), wide = std::max(width, height);
  reach_ =
      std::max({std::fabs(window_.x0), std::fabs(window_.x1), std::fabs(window_.y0), std::fabs(window_.y1)});
  side_ = grid.side;
  cells_per_x_ = grid.side / width;
  cells_per_y_ = grid.side / height;
  tolerance_ = narrow / grid.side / 256;
  usable_ = projection_.usable() && tolerance_ > reach_ * 0x1p-40 && wide < narrow * 0x1p10 &&
            wide > 0x1p-100 && reach_ < 0x1p100 && unit_ > 0x1p-300 && unit_ < 0x1p300;
}

ScreenPoint Screen::project(const Vec3d& p) const {
  const FramePoint f = projection_(p);
  if (!(f.at.radius < HUGE_VAL)) return {0, 0, 0, unplaced};
  const WindowPlace at = window_place(f);
  const double x = (at.x - window_.x0) * cells_per_x_, y = (at.y - window_.y0) * cells_per_y_;
  if (!(at.error < tolerance_) || !(std::max(std::fabs(x), std::fabs(y)) < farthest_cell))
    return {0, 0, 0, unplaced | code(f)};
  std::uint32_t c = 0;
  if (f.along < -f.at.radius) c |= behind_viewer;
  if (x < -margin) c |= beyond_left;
  if (x > side_ + margin) c |= beyond_right;
  if (y < -margin) c |= beyond_bottom;
  if (y > side_ + margin) c |= beyond_top;
  return {static_cast<float>(x), static_cast<float>(y), depth(f), c};
}

std::uint32_t Screen::code(const FramePoint& p) const {
  const auto [x, y, w] = p.at.v;
  // How far a coordinate may be off once a border times w is taken from it (ERRORS.md, 7).
  const double error = (p.at.radius + 4 * unit_roundoff * p.at.size) * (1 + reach_) * 2;
  std::uint32_t c = 0;
  if (x - window_.x0 * w < -error) c |= beyond_left;
  if (x - window_.x1 * w > error) c |= beyond_right;
  if (y - window_.y0 * w < -error) c |= beyond_bottom;
  if (y - window_.y1 * w > error) c |= beyond_top;
  if (p.along < -p.at.radius) c |= behind_viewer;
  return c;
}

/// 1/λ for a finite eye, -λ for one at infinity.
float Screen::depth(const FramePoint& p) const {
  const Ball& d = projection_.determinant();
  const double least = d.value - d.radius, most = d.value + d.radius;
  if (!projection_.at_infinity()) return upper_float(unit_ * (most / (p.along - p.at.radius)));
  const double nearer = p.at.radius - p.along;
  return upper_float(nearer / (nearer > 0 ? least : most) / unit_);
}

float Screen::depth_bound(double lowest, const Ball& at_eye) const {
  const double least = at_eye.value - at_eye.radius, most = at_eye.value + at_eye.radius;
  if (!(least > 0) || !(most < HUGE_VAL)) return -infinity;
  const double depth = lowest / (lowest > 0 ? most : least);
  const double scaled = projection_.at_infinity() ? depth / unit_ : depth * unit_;
  const double bound = scaled - std::fabs(scaled) * 0x1p-20;
  // Below the smallest normal number float32 has no relative precision left.
  if (!(std::fabs(bound) > 0x1p-100) || !(bound > -0x1p100)) return -infinity;
  return static_cast<float>(std::min(bound, 0x1p100));
}

}  // namespace provis
