#include "src/segment/frustum.hpp"

#include <algorithm>
#include <cmath>

namespace provis {

Frustum::Frustum(const PathProjection& projection, const PathGeometry& path, const PixelRect& area,
                 const TimeRange& range)
    : margin_(projection.margin()) {
  const Centre first = pixel_centre(path, {area.column, area.row}),
               last = pixel_centre(path, {area.column + area.width - 1, area.row + area.height - 1});
  const Vec3d x = projection.row_x(), y = projection.row_y(), z = projection.row_z();
  inward_ = {x - first.x * z, last.x * z - x, y - last.y * z, first.y * z - y, z};
  for (int k = 0; k <= parts; ++k)
    times_[static_cast<std::size_t>(k)] = range.begin + (range.end - range.begin) * k / parts;
  for (std::size_t s = 0; s < sides; ++s) {
    std::array<double, parts + 1> at;
    for (std::size_t k = 0; k <= parts; ++k) at[k] = dot(inward_[s], projection.viewpoint(times_[k]));
    for (std::size_t k = 0; k < parts; ++k) least_[s][k] = std::min(at[k], at[k + 1]) - margin_;
  }
}

template <class Farthest>
PartRange Frustum::touched_by(const Farthest& farthest) const {
  PartRange r{0, parts - 1};
  if (!(margin_ < HUGE_VAL)) return r;
  for (std::size_t s = 0; s < sides; ++s) {
    const double most = farthest(inward_[s]);
    const auto& least = least_[s];
    // Products with viewpoints are linear in time, so what is certainly outside lies at one end.
    while (r.first <= r.last && most < least[static_cast<std::size_t>(r.first)]) ++r.first;
    while (r.first <= r.last && most < least[static_cast<std::size_t>(r.last)]) --r.last;
    if (r.empty()) return r;
  }
  return r;
}

PartRange Frustum::touched(const ClusterBox& box) const {
  return touched_by([&](const Vec3d& n) {
    return (n.x > 0 ? n.x * box.upper.x : n.x * box.lower.x) +
           (n.y > 0 ? n.y * box.upper.y : n.y * box.lower.y) +
           (n.z > 0 ? n.z * box.upper.z : n.z * box.lower.z);
  });
}

PartRange Frustum::touched(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
  return touched_by([&](const Vec3d& n) { return std::max({dot(n, a), dot(n, b), dot(n, c)}); });
}

double Frustum::nearest(const ClusterBox& box) const {
  const Vec3d& n = inward_[sides - 1];
  return (n.x < 0 ? n.x * box.upper.x : n.x * box.lower.x) +
         (n.y < 0 ? n.y * box.upper.y : n.y * box.lower.y) +
         (n.z < 0 ? n.z * box.upper.z : n.z * box.lower.z) - margin_;
}

double Frustum::nearest(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
  const Vec3d& n = inward_[sides - 1];
  return std::min({dot(n, a), dot(n, b), dot(n, c)}) - margin_;
}

}  // namespace provis
