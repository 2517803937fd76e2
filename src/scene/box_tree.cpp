#include "src/scene/box_tree.hpp"

#include <algorithm>
#include <numeric>

namespace provis {
namespace {

constexpr std::uint32_t leaf_size = 8;

Vec3d lower(const Vec3d& a, const Vec3d& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}

Vec3d upper(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

std::vector<PrimitiveId> all_triangles(const Scene& scene) {
  std::vector<PrimitiveId> all(scene.triangles().size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

Box join(const Box& a, const Box& b) { return {lower(a.lower, b.lower), upper(a.upper, b.upper)}; }

double middle(const Box& b, int axis) {
  const double lo = axis == 0 ? b.lower.x : axis == 1 ? b.lower.y : b.lower.z;
  const double hi = axis == 0 ? b.upper.x : axis == 1 ? b.upper.y : b.upper.z;
  return lo / 2 + hi / 2;
}

int longest_axis(const Box& b) {
  const double x = b.upper.x - b.lower.x, y = b.upper.y - b.lower.y, z = b.upper.z - b.lower.z;
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

}  // namespace

Box box_around(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return {lower(lower(a, b), c), upper(upper(a, b), c)};
}

BoxTree::BoxTree(const Scene& scene) : BoxTree(scene, all_triangles(scene)) {}

BoxTree::BoxTree(const Scene& scene, std::span<const PrimitiveId> triangles) : order_(triangles.size()) {
  std::vector<Box> boxes(order_.size());
  for (std::size_t k = 0; k < boxes.size(); ++k)
    boxes[k] = box_around(scene.corner(triangles[k], 0), scene.corner(triangles[k], 1),
                          scene.corner(triangles[k], 2));
  std::iota(order_.begin(), order_.end(), 0u);
  if (order_.empty()) return;
  nodes_.emplace_back();
  build(boxes, 0, 0, static_cast<std::uint32_t>(order_.size()));
  for (std::uint32_t& k : order_) k = triangles[k];
}

/// Halves at the median, so the depth stays below 32 and the traversal's stack below 64.
void BoxTree::build(const std::vector<Box>& boxes, std::uint32_t node, std::uint32_t begin,
                    std::uint32_t end) {
  Box box = boxes[order_[begin]];
  for (std::uint32_t k = begin + 1; k < end; ++k) box = join(box, boxes[order_[k]]);
  nodes_[node].box = box;
  if (end - begin <= leaf_size) {
    nodes_[node].first = begin;
    nodes_[node].count = end - begin;
    return;
  }
  const int axis = longest_axis(box);
  const std::uint32_t mid = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + mid, order_.begin() + end,
      [&](std::uint32_t a, std::uint32_t b) { return middle(boxes[a], axis) < middle(boxes[b], axis); });
  const auto children = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node].first = children;
  nodes_.resize(nodes_.size() + 2);
  build(boxes, children, begin, mid);
  build(boxes, children + 1, mid, end);
}

}  // namespace provis
