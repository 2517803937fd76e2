#include "src/region/viewpoints.hpp"

#include <algorithm>
#include <cmath>

#include "src/scene/on_occluder.hpp"

namespace provis {
namespace {

Vec3d clamped(const Vec3d& p, const ViewCell& cell) {
  return {std::clamp(p.x, cell.lower.x, cell.upper.x), std::clamp(p.y, cell.lower.y, cell.upper.y),
          std::clamp(p.z, cell.lower.z, cell.upper.z)};
}

/// Shares of the way from the lower to the upper corner.
Vec3d inside(const ViewCell& cell, const Vec3d& share) {
  const auto between = [](double lo, double hi, double s) { return lo * (1 - s) + hi * s; };
  return clamped({between(cell.lower.x, cell.upper.x, share.x), between(cell.lower.y, cell.upper.y, share.y),
                  between(cell.lower.z, cell.upper.z, share.z)},
                 cell);
}

/// The k-th point of a sequence that fills the unit cube evenly: multiples of powers of the root of x^4 = x
/// + 1.
Vec3d even_share(std::uint64_t k, std::uint64_t seed) {
  constexpr double root = 1.2207440846057596;
  const auto share = [&](double step) {
    const double x = 0.5 + static_cast<double>(k + 1 + 1000 * (seed % 1000)) * step;
    return x - std::floor(x);
  };
  return {share(1 / root), share(1 / (root * root)), share(1 / (root * root * root))};
}

}  // namespace

std::vector<Vec3d> free_viewpoints(const Scene& scene, const ViewCell& cell, int more, std::uint64_t seed) {
  std::vector<Vec3d> points;
  const auto add = [&](const Vec3d& p) {
    if (std::find(points.begin(), points.end(), p) != points.end()) return true;
    if (on_occluder(scene, p)) return false;
    points.push_back(p);
    return true;
  };
  add(inside(cell, {0.5, 0.5, 0.5}));
  for (int k = 0; k < 8; ++k) {
    const auto share = [&](int bit, double pull) { return k & bit ? 1 - pull : pull; };
    for (const double pull : {0.0, 0x1p-30, 0x1p-20, 0x1p-10, 0x1p-4})
      if (add(inside(cell, {share(1, pull), share(2, pull), share(4, pull)}))) break;
  }
  for (int k = 0; k < more; ++k) add(inside(cell, even_share(static_cast<std::uint64_t>(k), seed)));
  return points;
}

}  // namespace provis
