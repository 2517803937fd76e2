#pragma once
// The lines of one leaf: those of its facets, and those of pairs of facets, made when first asked for.

#include <deque>
#include <unordered_map>

#include "src/point/cell.hpp"

namespace provis {

/// The lines that bound where `o` hides something: one depth line, three edges, perhaps the front line.
using Region = boost::container::small_vector<Side, 5>;

template <Arithmetic A>
class LeafLines {
 public:
  LeafLines(Signs<A>& signs, const Facets& facets, PartLines<A>& part)
      : signs_(signs), facets_(facets.facets), part_(part) {}

  const FacetLines<A>& of(std::uint32_t facet) { return part_.of(facet); }

  /// The line that is positive where facet `near` is strictly nearer than facet `far`; null if both lie in
  /// one plane. Indices are into the frame's facets.
  Side depth(std::uint32_t near, std::uint32_t far);

  /// The line that is positive where the facet lies beyond the window (eye at infinity).
  Side front(std::uint32_t facet);

  /// The lines inside which the facet has hits.
  template <bool Cut>
  void append_cone(std::uint32_t facet, Region& region) {
    for (const Line& e : part_.of(facet).edges) region.push_back({&e, false});
    if constexpr (Cut)
      if (facets_[facet].cut) region.push_back(front(facet));
  }

 private:
  Line* make_depth(std::uint32_t first, std::uint32_t second);

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  PartLines<A>& part_;
  std::deque<Line> storage_;
  std::unordered_map<std::uint64_t, const Line*> depth_;
  std::unordered_map<std::uint32_t, const Line*> front_;
};

template <Arithmetic A>
Side LeafLines<A>::depth(std::uint32_t near, std::uint32_t far) {
  const std::uint32_t first = std::min(near, far), second = std::max(near, far);
  const auto [it, fresh] = depth_.try_emplace(std::uint64_t{first} << 32 | second, nullptr);
  if (fresh) {
    Line* line = make_depth(first, second);
    it->second = signs_.vanishes(*line) ? nullptr : line;
  }
  return {it->second, near != first};
}

template <Arithmetic A>
Line* LeafLines<A>::make_depth(std::uint32_t first, std::uint32_t second) {
  const Facet &f = facets_[first], &g = facets_[second];
  Line& line = storage_.emplace_back();
  line.kind = LineKind::depth;
  line.first = f.corners;
  line.second = g.corners;
  line.planes[0] = first;
  line.planes[1] = second;
  // A corner that both triangles share lies on the crossing of their planes.
  int shared = 0;
  for (const std::uint32_t p : f.points)
    if (shared < 2 && (p == g.points[0] || p == g.points[1] || p == g.points[2])) line.points[shared++] = p;
  line.approx = approximate(depth_line(signs_.geometry(), part_.of(first).plane, part_.of(second).plane));
  return &line;
}

template <Arithmetic A>
Side LeafLines<A>::front(std::uint32_t facet) {
  const auto [it, fresh] = front_.try_emplace(facet, nullptr);
  if (fresh) {
    Line& line = storage_.emplace_back();
    line.kind = LineKind::front;
    line.first = facets_[facet].corners;
    line.approx = signs_.shadow(line);
    it->second = &line;
  }
  return {it->second, false};
}

}  // namespace provis
