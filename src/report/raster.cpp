#include "src/report/raster.hpp"

#include <algorithm>
#include <cmath>

namespace provis {

namespace {

// Below this share of its length a vector's forward part is too small to divide by.
constexpr double safely_in_front = 1e-9;

// First and last pixel that an extent touches, with one to spare on both sides for rounding.
void set_range(double low, double high, int size, int& begin, int& end) {
  begin = static_cast<int>(std::clamp(std::floor(low) - 1, 0.0, static_cast<double>(size)));
  end = static_cast<int>(std::clamp(std::floor(high) + 2, 0.0, static_cast<double>(size)));
}

}  // namespace

Raster::Raster(const Vec3d& eye, Projection projection, const Frame& frame, int width, int height)
    : eye_(eye),
      frame_(frame),
      parallel_(projection == Projection::parallel),
      width_(width),
      height_(height) {
  const double volume = dot(frame.right, cross(frame.up, frame.forward));
  dual_ = {1 / volume * cross(frame.up, frame.forward), 1 / volume * cross(frame.forward, frame.right),
           1 / volume * cross(frame.right, frame.up)};
}

Vec3d Raster::to_frame(const Vec3d& p) const {
  const Vec3d from_eye = p - eye_;
  return {dot(dual_[0], from_eye), dot(dual_[1], from_eye), dot(dual_[2], from_eye)};
}

Vec3d Raster::centre(int column, int row) const {
  const Window& w = frame_.window;
  return {w.x0 + (column + 0.5) * (w.x1 - w.x0) / width_, w.y1 - (row + 0.5) * (w.y1 - w.y0) / height_, 1};
}

Vec3d Raster::ray_origin(const Vec3d& centre) const {
  return parallel_ ? eye_ + centre.x * frame_.right + centre.y * frame_.up : eye_;
}

Vec3d Raster::ray_direction(const Vec3d& centre) const {
  return parallel_ ? frame_.forward : frame_.forward + centre.x * frame_.right + centre.y * frame_.up;
}

std::array<double, 2> Raster::to_pixels(double x, double y) const {
  const Window& w = frame_.window;
  return {(x - w.x0) / (w.x1 - w.x0) * width_, (w.y1 - y) / (w.y1 - w.y0) * height_};
}

PixelBox Raster::box(std::span<const Vec3d> points) const {
  const PixelBox everything{0, width_, 0, height_};
  const bool behind = std::all_of(points.begin(), points.end(), [](const Vec3d& p) { return p.z <= 0; });
  if (behind) return {};
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (const Vec3d& p : points) {
    const double reach = std::max(std::abs(p.x), std::abs(p.y));
    if (!parallel_ && !(p.z > safely_in_front * reach)) return everything;
    const double depth = parallel_ ? 1 : p.z;
    const std::array<double, 2> pixel = to_pixels(p.x / depth, p.y / depth);
    for (std::size_t k = 0; k < 2; ++k) {
      if (!std::isfinite(pixel[k])) return everything;
      low[k] = std::min(low[k], pixel[k]);
      high[k] = std::max(high[k], pixel[k]);
    }
  }
  PixelBox box;
  set_range(low[0], high[0], width_, box.x0, box.x1);
  set_range(low[1], high[1], height_, box.y0, box.y1);
  return box;
}

}  // namespace provis
