#pragma once
// What lies in a beam, as it looks along the beam's middle ray: a quick way to what a segment may cross.

#include <algorithm>
#include <vector>

#include "src/offset/beam.hpp"

namespace provis::offset {

/// The boxes around the opaque entries of a list, along two linear coordinates that do not change along the
/// middle ray. A segment inside the beam changes little in them, so it keeps clear of most boxes.
class Shadows {
 public:
  /// list: in order of least depth.
  Shadows(const Beam& beam, const std::vector<Entry>& list, const std::vector<Facet>& facets);

  /// Calls visit(facet) for the opaque entries up to a depth that the segment may cross, the nearest first,
  /// until visit returns true.
  template <class Visit>
  void along(const Point& from, const Point& to, double depth, const Visit& visit) const;

 private:
  struct Shadow {
    double x0, x1, y0, y1;
    double near;
    std::uint32_t facet;
  };
  Interval x(const Point& p) const { return share_ * component(p, i_) - slope_i_ * component(p, along_); }
  Interval y(const Point& p) const { return share_ * component(p, j_) - slope_j_ * component(p, along_); }

  int along_ = 0, i_ = 1, j_ = 2;
  Interval share_, slope_i_, slope_j_;
  std::vector<Shadow> all_;
};

template <class Visit>
void Shadows::along(const Point& from, const Point& to, double depth, const Visit& visit) const {
  const Interval xs[2] = {x(from), x(to)}, ys[2] = {y(from), y(to)};
  const double x0 = std::min(xs[0].inf(), xs[1].inf()), x1 = std::max(xs[0].sup(), xs[1].sup()),
               y0 = std::min(ys[0].inf(), ys[1].inf()), y1 = std::max(ys[0].sup(), ys[1].sup());
  for (const Shadow& s : all_) {
    if (s.near > depth) break;
    if ((s.x0 > x1) | (s.x1 < x0) | (s.y0 > y1) | (s.y1 < y0)) continue;
    if (visit(s.facet)) break;
  }
}

}  // namespace provis::offset
