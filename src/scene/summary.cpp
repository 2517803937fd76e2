#include <algorithm>

#include "predicates/zero_area.hpp"
#include "provis/error.hpp"
#include "provis/scene.hpp"
#include "src/scene/parallel.hpp"

namespace provis {
namespace {

/// The smallest axis-parallel box around what it was given.
struct Extent {
  bool empty = true;
  Vec3d lower, upper;

  void add(const Vec3d& low, const Vec3d& high) {
    const Vec3d& l = empty ? low : lower;
    const Vec3d& u = empty ? high : upper;
    lower = {std::min(l.x, low.x), std::min(l.y, low.y), std::min(l.z, low.z)};
    upper = {std::max(u.x, high.x), std::max(u.y, high.y), std::max(u.z, high.z)};
    empty = false;
  }
};

/// Sums over a run of triangles. Runs are joined in order, so that of -0 and +0 the first one stays.
struct TriangleSums {
  std::size_t degenerate = 0;
  std::array<std::size_t, 4> by_flags{};
  Extent extent;

  static TriangleSums joined(TriangleSums a, const TriangleSums& b) {
    a.degenerate += b.degenerate;
    for (std::size_t f = 0; f < a.by_flags.size(); ++f) a.by_flags[f] += b.by_flags[f];
    if (!b.extent.empty) a.extent.add(b.extent.lower, b.extent.upper);
    return a;
  }
};

TriangleSums sum_triangles(const Scene& scene) {
  const auto add = [&scene](std::size_t begin, std::size_t end, TriangleSums sums) {
    for (std::size_t t = begin; t < end; ++t) {
      const Vec3d &a = scene.corner(t, 0), &b = scene.corner(t, 1), &c = scene.corner(t, 2);
      for (const Vec3d* p : {&a, &b, &c}) sums.extent.add(*p, *p);
      sums.degenerate += zero_area(a, b, c);
      ++sums.by_flags[scene.triangle_flags()[t]];
    }
    return sums;
  };
  return parallel_sum(scene.triangles().size(), TriangleSums{}, add, TriangleSums::joined);
}

void add_spheres(SceneSummary& summary, Extent& extent, const Scene& scene) {
  for (std::size_t s = 0; s < scene.spheres().size(); ++s) {
    const auto& [center, radius] = scene.spheres()[s];
    const Vec3d r{radius, radius, radius};
    extent.add(center - r, center + r);
    summary.degenerate_spheres += radius == 0;
    ++summary.spheres_by_flags[scene.sphere_flags()[s]];
    summary.smallest_radius = s == 0 ? radius : std::min(summary.smallest_radius, radius);
    summary.largest_radius = std::max(summary.largest_radius, radius);
  }
}

}  // namespace

SceneSummary summarize(const Scene& scene, const Context& context) {
  const TriangleSums sums = on_threads(context, [&] { return sum_triangles(scene); });
  if (context.cancelled()) throw Error(Error::Code::cancelled, "", "interrupted while counting");
  SceneSummary summary;
  summary.triangles = scene.triangles().size();
  summary.spheres = scene.spheres().size();
  summary.vertices = scene.vertices().size();
  summary.degenerate_triangles = sums.degenerate;
  summary.triangles_by_flags = sums.by_flags;
  Extent extent = sums.extent;
  add_spheres(summary, extent, scene);
  summary.lower = extent.lower;
  summary.upper = extent.upper;
  for (std::size_t flags = 0; flags < summary.triangles_by_flags.size(); ++flags) {
    const std::size_t count = summary.triangles_by_flags[flags] + summary.spheres_by_flags[flags];
    if ((flags & single_sided) != 0) summary.single_sided += count;
    if ((flags & see_through) != 0) summary.see_through += count;
  }
  return summary;
}

std::size_t array_bytes(const Scene& scene) {
  return scene.vertices().size_bytes() + scene.triangles().size_bytes() +
         scene.triangle_flags().size_bytes() + scene.spheres().size_bytes() +
         scene.sphere_flags().size_bytes();
}

}  // namespace provis
