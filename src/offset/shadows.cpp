#include "src/offset/shadows.hpp"

#include <cmath>

namespace provis::offset {

Shadows::Shadows(const Beam& beam, const std::vector<Entry>& list, const std::vector<Facet>& facets) {
  // Any numbers would do: a segment lies between its ends in every linear coordinate.
  const auto middle = [&](int axis) { return component(beam.ray, axis).inf(); };
  for (const int axis : {1, 2})
    if (std::fabs(middle(axis)) > std::fabs(middle(along_))) along_ = axis;
  i_ = (along_ + 1) % 3;
  j_ = (along_ + 2) % 3;
  share_ = Interval(middle(along_));
  slope_i_ = Interval(middle(i_));
  slope_j_ = Interval(middle(j_));
  all_.reserve(list.size());
  for (const Entry& e : list) {
    const Facet& f = facets[e.facet];
    if (!f.opaque) continue;
    const Polygon polygon = polygon_of(e, f);
    Shadow s{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, e.near, e.facet};
    for (std::size_t k = 0; k < polygon.size; ++k) {
      const Interval px = x(polygon.corners[k].at), py = y(polygon.corners[k].at);
      s.x0 = std::min(s.x0, px.inf());
      s.x1 = std::max(s.x1, px.sup());
      s.y0 = std::min(s.y0, py.inf());
      s.y1 = std::max(s.y1, py.sup());
    }
    all_.push_back(s);
  }
}

}  // namespace provis::offset
