#pragma once
// Clusters of triangles that lie near each other, and a tree over them. Boxes are exact: corners are input
// numbers.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "provis/scene.hpp"

namespace provis {

struct ClusterBox {
  Vec3d lower, upper;
};

/// A full binary tree by levels: cluster k of level l holds clusters 2k and 2k+1 of level l-1. Level 0 holds
/// runs of triangles along a space-filling curve.
class ClusterTree {
 public:
  static constexpr std::uint32_t cluster_size = 8;

  explicit ClusterTree(const Scene& scene);

  /// 0 for a scene without triangles.
  std::uint32_t levels() const { return static_cast<std::uint32_t>(boxes_.size()); }
  std::uint32_t size(std::uint32_t level) const { return static_cast<std::uint32_t>(boxes_[level].size()); }
  const ClusterBox& box(std::uint32_t level, std::uint32_t k) const { return boxes_[level][k]; }

  /// Calls visit(triangle) for those of a cluster of level 0.
  template <class Visit>
  void for_triangles(std::uint32_t k, const Visit& visit) const {
    const std::size_t end = std::min<std::size_t>(order_.size(), (std::size_t{k} + 1) * cluster_size);
    for (std::size_t i = std::size_t{k} * cluster_size; i < end; ++i) visit(order_[i]);
  }

  /// No coordinate is larger.
  double reach() const { return reach_; }

 private:
  std::vector<PrimitiveId> order_;
  std::vector<std::vector<ClusterBox>> boxes_;
  double reach_ = 0;
};

}  // namespace provis
