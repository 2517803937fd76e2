#include "tests/support/box_tree.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace provis::test {

namespace {

constexpr std::uint32_t leaf_size = 4;

double down(double v) { return std::nextafter(v, -HUGE_VAL); }
double up(double v) { return std::nextafter(v, HUGE_VAL); }

}  // namespace

BoxTree::BoxTree(const SceneArrays& scene) : order_(scene.triangles.size()) {
  for (const Triangle& t : scene.triangles) {
    const Vec3d &a = scene.vertices[t[0]], &b = scene.vertices[t[1]], &c = scene.vertices[t[2]];
    boxes_.push_back({Range{std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x})},
                      Range{std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y})},
                      Range{std::min({a.z, b.z, c.z}), std::max({a.z, b.z, c.z})}});
  }
  std::iota(order_.begin(), order_.end(), PrimitiveId{0});
  if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t count) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  Box box = boxes_[order_[first]];
  for (std::uint32_t i = first; i < first + count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box[axis].lo = std::min(box[axis].lo, boxes_[order_[i]][axis].lo);
      box[axis].hi = std::max(box[axis].hi, boxes_[order_[i]][axis].hi);
    }
  }
  nodes_.push_back({box, first, count, 0});
  if (count <= leaf_size) return index;

  std::size_t longest = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (box[axis].hi - box[axis].lo > box[longest].hi - box[longest].lo) longest = axis;
  }
  const auto middle_of = [&](PrimitiveId t) { return boxes_[t][longest].lo / 2 + boxes_[t][longest].hi / 2; };
  const auto begin = order_.begin() + first;
  std::nth_element(begin, begin + count / 2, begin + count,
                   [&](PrimitiveId a, PrimitiveId b) { return middle_of(a) < middle_of(b); });
  build(first, count / 2);
  const std::uint32_t second = build(first + count / 2, count - count / 2);
  nodes_[index].second_child = second;
  nodes_[index].count = 0;
  return index;
}

// get_d truncates, so the exact value lies between the result and its neighbour away from zero.
BoxTree::Range BoxTree::outward(const mpq_class& exact) {
  const double near = exact.get_d();
  return {down(near), up(near)};
}

// Slabs. Per axis the parameters at which the segment may be inside the slab are bounded; where the direction
// may be zero the hull has to do. Each float64 operation is followed by a step outward.
bool BoxTree::may_meet(const Box& box, const Segment& segment) {
  double enter = 0, leave = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (segment.hull[axis].hi < box[axis].lo || segment.hull[axis].lo > box[axis].hi) return false;
    const Range& d = segment.span[axis];
    if (d.lo <= 0 && d.hi >= 0) continue;
    const double near =
        d.lo > 0 ? down(box[axis].lo - segment.from[axis].hi) : up(box[axis].hi - segment.from[axis].lo);
    const double far =
        d.lo > 0 ? up(box[axis].hi - segment.from[axis].lo) : down(box[axis].lo - segment.from[axis].hi);
    enter = std::max(enter, down(std::min(near / d.lo, near / d.hi)));
    leave = std::min(leave, up(std::max(far / d.lo, far / d.hi)));
  }
  return enter <= leave;
}

void BoxTree::visit_segment(const Vec3<mpq_class>& from, const Vec3<mpq_class>& to,
                            const std::function<bool(PrimitiveId)>& visit) const {
  if (nodes_.empty()) return;
  const Vec3<mpq_class> span = to - from;
  Segment segment{{outward(from.x), outward(from.y), outward(from.z)},
                  {outward(span.x), outward(span.y), outward(span.z)},
                  {outward(to.x), outward(to.y), outward(to.z)}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    segment.hull[axis].lo = std::min(segment.hull[axis].lo, segment.from[axis].lo);
    segment.hull[axis].hi = std::max(segment.hull[axis].hi, segment.from[axis].hi);
  }
  std::vector<std::uint32_t> open{0};
  while (!open.empty()) {
    const std::uint32_t index = open.back();
    const Node& node = nodes_[index];
    open.pop_back();
    if (!may_meet(node.box, segment)) continue;
    for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
      if (may_meet(boxes_[order_[i]], segment) && !visit(order_[i])) return;
    }
    if (node.count == 0) {
      open.push_back(node.second_child);
      open.push_back(index + 1);
    }
  }
}

}  // namespace provis::test
