#include <algorithm>

#include "predicates/zero_area.hpp"
#include "provis/scene.hpp"

namespace provis {
namespace {

/// The smallest axis-parallel box around what it was given; zero while it was given nothing.
class Extent {
 public:
  explicit Extent(SceneSummary& summary) : summary_(summary) {}

  void add(const Vec3d& low, const Vec3d& high) {
    Vec3d& l = summary_.lower;
    Vec3d& u = summary_.upper;
    l = empty_ ? low : Vec3d{std::min(l.x, low.x), std::min(l.y, low.y), std::min(l.z, low.z)};
    u = empty_ ? high : Vec3d{std::max(u.x, high.x), std::max(u.y, high.y), std::max(u.z, high.z)};
    empty_ = false;
  }

 private:
  SceneSummary& summary_;
  bool empty_ = true;
};

void add_flags(SceneSummary& summary, std::uint8_t flags) {
  summary.single_sided += (flags & single_sided) != 0;
  summary.see_through += (flags & see_through) != 0;
}

}  // namespace

SceneSummary summarize(const Scene& scene) {
  SceneSummary summary;
  summary.triangles = scene.triangles().size();
  summary.spheres = scene.spheres().size();
  summary.vertices = scene.vertices().size();
  Extent extent(summary);
  for (std::size_t t = 0; t < summary.triangles; ++t) {
    for (int k = 0; k < 3; ++k) extent.add(scene.corner(t, k), scene.corner(t, k));
    summary.degenerate_triangles += zero_area(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2));
    add_flags(summary, scene.triangle_flags()[t]);
  }
  for (std::size_t s = 0; s < summary.spheres; ++s) {
    const auto& [center, radius] = scene.spheres()[s];
    const Vec3d r{radius, radius, radius};
    extent.add(center - r, center + r);
    summary.degenerate_spheres += radius == 0;
    add_flags(summary, scene.sphere_flags()[s]);
  }
  return summary;
}

}  // namespace provis
