#include "src/segment/cluster_tree.hpp"

#include <cmath>

#include "src/scene/parallel.hpp"
#include "src/scene/parallel_sort.hpp"

namespace provis {
namespace {

Vec3d lower(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3d upper(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

/// The bits of a number below 2^10, two zeros between them.
std::uint64_t spread(std::uint64_t x) {
  x = (x | x << 16) & 0x30000ff;
  x = (x | x << 8) & 0x300f00f;
  x = (x | x << 4) & 0x30c30c3;
  return (x | x << 2) & 0x9249249;
}

/// One coordinate's place in the scene, below 2^10: any will do, a better one makes better clusters.
std::uint64_t place(double at, double low, double high) {
  const double share = high > low ? (at - low) / (high - low) : 0;
  return spread(share > 0 ? static_cast<std::uint64_t>(std::min(share * 1023, 1023.0)) : 0);
}

}  // namespace

ClusterTree::ClusterTree(const Scene& scene) : order_(scene.triangles().size()) {
  const std::size_t n = order_.size();
  if (n == 0) return;
  ClusterBox all{scene.corner(0, 0), scene.corner(0, 0)};
  for (const Vec3d& v : scene.vertices()) all = {lower(all.lower, v), upper(all.upper, v)};
  for (const double x : {all.lower.x, all.lower.y, all.lower.z, all.upper.x, all.upper.y, all.upper.z})
    reach_ = std::max(reach_, std::fabs(x));

  std::vector<std::uint64_t> keys(n);
  constexpr std::size_t chunk = 4096;
  parallel_for((n + chunk - 1) / chunk, [&](std::size_t c) {
    for (std::size_t t = c * chunk; t < std::min(n, (c + 1) * chunk); ++t) {
      const Vec3d &p = scene.corner(t, 0), &q = scene.corner(t, 1), &r = scene.corner(t, 2);
      const auto middle = [](double a, double b, double d) { return a / 3 + b / 3 + d / 3; };
      const std::uint64_t code = place(middle(p.x, q.x, r.x), all.lower.x, all.upper.x) << 2 |
                                 place(middle(p.y, q.y, r.y), all.lower.y, all.upper.y) << 1 |
                                 place(middle(p.z, q.z, r.z), all.lower.z, all.upper.z);
      keys[t] = code << 32 | t;
    }
  });
  parallel_sort(std::span(keys));
  for (std::size_t k = 0; k < n; ++k) order_[k] = static_cast<PrimitiveId>(keys[k]);

  boxes_.emplace_back((n + cluster_size - 1) / cluster_size);
  const auto fill = [&](std::vector<ClusterBox>& level, const auto& box_of) {
    parallel_for((level.size() + chunk - 1) / chunk, [&](std::size_t c) {
      for (std::size_t k = c * chunk; k < std::min(level.size(), (c + 1) * chunk); ++k) level[k] = box_of(k);
    });
  };
  fill(boxes_[0], [&](std::size_t k) {
    ClusterBox box{scene.corner(order_[k * cluster_size], 0), scene.corner(order_[k * cluster_size], 0)};
    for_triangles(static_cast<std::uint32_t>(k), [&](PrimitiveId t) {
      for (int c = 0; c < 3; ++c)
        box = {lower(box.lower, scene.corner(t, c)), upper(box.upper, scene.corner(t, c))};
    });
    return box;
  });
  while (boxes_.back().size() > 1) {
    std::vector<ClusterBox> level((boxes_.back().size() + 1) / 2);
    const std::vector<ClusterBox>& below = boxes_.back();
    fill(level, [&](std::size_t k) {
      const ClusterBox &a = below[2 * k], &b = below[std::min(2 * k + 1, below.size() - 1)];
      return ClusterBox{lower(a.lower, b.lower), upper(a.upper, b.upper)};
    });
    boxes_.push_back(std::move(level));
  }
}

}  // namespace provis
