#include "src/offset/seams.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"
#include "src/scene/parallel.hpp"

namespace provis::offset {
namespace {

bool before(const Vec3d& a, const Vec3d& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/// Whether m lies strictly inside the segment from a to b, none of them equal.
bool inside_segment(const Vec3d& a, const Vec3d& b, const Vec3d& m) {
  for (int axis = 0; axis < 3; ++axis) {
    const double p = component(a, axis), q = component(b, axis);
    if (component(m, axis) < std::min(p, q) || component(m, axis) > std::max(p, q)) return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const Sign s = certain_sign([&]<class N>() {
      const Vec3<N> o = numbers<N>(a), n = cross(numbers<N>(b) - o, numbers<N>(m) - o);
      return component(n, axis);
    });
    if (s != Sign::zero) return false;
  }
  return true;
}

/// A median-split tree of points.
class PointTree {
 public:
  explicit PointTree(const std::vector<const Vec3d*>& points) : points_(points), order_(points.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    if (!order_.empty()) build(0, order_.size());
  }

  /// Calls visit with every point near the segment, and perhaps others; rounding only ever adds points.
  template <class Visit>
  void near_segment(const Vec3d& a, const Vec3d& b, const Visit& visit) const {
    if (!order_.empty()) search(0, 0, order_.size(), a, b, visit);
  }

 private:
  static constexpr std::size_t few = 8;
  struct Node {
    Vec3d lower, upper;
    std::size_t right = 0;  ///< the left child follows its parent
  };

  std::size_t build(std::size_t begin, std::size_t end);
  static bool may_meet(const Node& n, const Vec3d& a, const Vec3d& b);

  template <class Visit>
  void search(std::size_t node, std::size_t begin, std::size_t end, const Vec3d& a, const Vec3d& b,
              const Visit& visit) const {
    if (!may_meet(nodes_[node], a, b)) return;
    if (end - begin <= few) {
      for (std::size_t k = begin; k < end; ++k) visit(order_[k]);
      return;
    }
    const std::size_t middle = begin + (end - begin) / 2;
    search(node + 1, begin, middle, a, b, visit);
    search(nodes_[node].right, middle, end, a, b, visit);
  }

  const std::vector<const Vec3d*>& points_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

std::size_t PointTree::build(std::size_t begin, std::size_t end) {
  const std::size_t node = nodes_.size();
  Node n{*points_[order_[begin]], *points_[order_[begin]]};
  for (std::size_t k = begin; k < end; ++k) {
    const Vec3d& p = *points_[order_[k]];
    n.lower = {std::min(n.lower.x, p.x), std::min(n.lower.y, p.y), std::min(n.lower.z, p.z)};
    n.upper = {std::max(n.upper.x, p.x), std::max(n.upper.y, p.y), std::max(n.upper.z, p.z)};
  }
  nodes_.push_back(n);
  if (end - begin <= few) return node;
  const Vec3d size = n.upper - n.lower;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t middle = begin + (end - begin) / 2;
  const auto at_offset = [&](std::size_t k) { return order_.begin() + static_cast<std::ptrdiff_t>(k); };
  std::nth_element(at_offset(begin), at_offset(middle), at_offset(end),
                   [&](std::uint32_t i, std::uint32_t j) {
                     const double x = component(*points_[i], axis), y = component(*points_[j], axis);
                     return x != y ? x < y : i < j;
                   });
  build(begin, middle);
  const std::size_t right = build(middle, end);
  nodes_[node].right = right;
  return node;
}

/// Slabs in intervals: along each axis the segment is inside for a range of shares of the way.
bool PointTree::may_meet(const Node& n, const Vec3d& a, const Vec3d& b) {
  double from = 0, to = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = component(n.lower, axis), hi = component(n.upper, axis), p = component(a, axis),
                 q = component(b, axis);
    if ((p < lo && q < lo) || (p > hi && q > hi)) return false;
    if (p == q) continue;
    const Interval way = Interval(q) - Interval(p);
    const Interval s = (Interval(lo) - Interval(p)) / way, t = (Interval(hi) - Interval(p)) / way;
    from = std::max(from, std::min(s.inf(), t.inf()));
    to = std::min(to, std::max(s.sup(), t.sup()));
  }
  return !(from > to);
}

struct Run {
  std::uint32_t from, to, slot;
};

}  // namespace

Seams::Seams(const Scene& scene) : welded_(scene.vertices().size()), edge_of_(3 * scene.triangles().size()) {
  std::vector<std::uint32_t> order(welded_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return before(scene.vertices()[i], scene.vertices()[j]);
  });
  for (const std::uint32_t i : order) {
    if (positions_.empty() || before(*positions_.back(), scene.vertices()[i]))
      positions_.push_back(&scene.vertices()[i]);
    welded_[i] = static_cast<std::uint32_t>(positions_.size() - 1);
  }

  std::vector<Run> runs;
  for (std::uint32_t slot = 0; slot < edge_of_.size(); ++slot) {
    const Triangle& t = scene.triangles()[slot / 3];
    const std::uint32_t a = welded_[t[slot % 3]], b = welded_[t[(slot + 1) % 3]];
    runs.push_back({std::min(a, b), std::max(a, b), slot});
  }
  std::sort(runs.begin(), runs.end(),
            [](const Run& r, const Run& s) { return r.from != s.from ? r.from < s.from : r.to < s.to; });
  std::vector<Run> edges;
  for (const Run& r : runs) {
    if (edges.empty() || edges.back().from != r.from || edges.back().to != r.to) edges.push_back(r);
    edge_of_[r.slot] = static_cast<std::uint32_t>(edges.size() - 1);
  }

  // Vertices are numbered in lexicographic order, which is the order along any segment.
  const PointTree tree(positions_);
  std::vector<std::vector<std::uint32_t>> found(edges.size());
  parallel_for(edges.size(), [&](std::size_t e) {
    const RoundUp guard;
    const auto [from, to, slot] = edges[e];
    tree.near_segment(position(from), position(to), [&, from = from, to = to](std::uint32_t m) {
      if (m > from && m < to && inside_segment(position(from), position(to), position(m)))
        found[e].push_back(m);
    });
    std::sort(found[e].begin(), found[e].end());
  });
  first_.push_back(0);
  for (const auto& f : found) {
    inside_.insert(inside_.end(), f.begin(), f.end());
    first_.push_back(static_cast<std::uint32_t>(inside_.size()));
  }
}

}  // namespace provis::offset
