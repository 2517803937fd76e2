#pragma once
// A tree of boxes around triangles of a scene. The boxes are exact: corners are input numbers.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "provis/scene.hpp"

namespace provis {

struct Box {
  Vec3d lower, upper;
};

Box box_around(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// Bit k of a corner's place is set where coordinate k is the upper one.
inline std::array<Vec3d, 8> corners_of(const Box& box) {
  std::array<Vec3d, 8> corners;
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = {k & 1 ? box.upper.x : box.lower.x, k & 2 ? box.upper.y : box.lower.y,
                  k & 4 ? box.upper.z : box.lower.z};
  return corners;
}

/// Whether two closed boxes have a common point.
inline bool meet(const Box& a, const Box& b) {
  return a.lower.x <= b.upper.x && b.lower.x <= a.upper.x && a.lower.y <= b.upper.y &&
         b.lower.y <= a.upper.y && a.lower.z <= b.upper.z && b.lower.z <= a.upper.z;
}

class BoxTree {
 public:
  explicit BoxTree(const Scene& scene);

  /// Of these triangles only; visits name them by their ids in the scene.
  BoxTree(const Scene& scene, std::span<const PrimitiveId> triangles);

  /// Calls visit(triangle) for every triangle below boxes that may_meet accepts, until visit returns true.
  /// Returns whether it did.
  template <class MayMeet, class Visit>
  bool any(const MayMeet& may_meet, const Visit& visit) const {
    if (nodes_.empty()) return false;
    std::array<std::uint32_t, 64> stack;
    std::size_t size = 0;
    stack[size++] = 0;
    while (size > 0) {
      const Node& node = nodes_[stack[--size]];
      if (!may_meet(node.box)) continue;
      if (node.count == 0) {
        stack[size++] = node.first;
        stack[size++] = node.first + 1;
        continue;
      }
      for (std::uint32_t k = 0; k < node.count; ++k)
        if (visit(order_[node.first + k])) return true;
    }
    return false;
  }

 private:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< of its triangles, or of its two children
    std::uint32_t count = 0;  ///< of triangles; 0 for an inner node
  };

  void build(const std::vector<Box>& boxes, std::uint32_t node, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> order_;
};

}  // namespace provis
