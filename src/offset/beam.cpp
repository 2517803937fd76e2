#include "src/offset/beam.hpp"

#include <algorithm>

namespace provis::offset {

Polygon polygon_of(const Entry& entry, const Facet& facet) {
  if (entry.cut) return *entry.cut;
  return whole(*facet.p[0], *facet.p[1], *facet.p[2]);
}

Beam::Beam(const Face& viewpoints, const Raster& raster, const Shafts& shafts, const Window& window)
    : face(viewpoints), directions(window), spaces(shafts.around(viewpoints, window)) {
  const auto mean = [](const Point& a, const Point& b) { return Interval(0.5) * (a + b); };
  viewpoint = mean(numbers<Interval>(face.corners[0]), numbers<Interval>(face.corners[2]));
  const Frame& f = raster.frame;
  const Interval x = Interval(0.5) * (Interval(window.x0) + Interval(window.x1)),
                 y = Interval(0.5) * (Interval(window.y0) + Interval(window.y1));
  ray = numbers<Interval>(f.forward) + x * numbers<Interval>(f.right) + y * numbers<Interval>(f.up);
}

Point Beam::viewpoint_towards(const Point& to) const {
  const auto middle = [](const Interval& x) { return 0.5 * x.inf() + 0.5 * x.sup(); };
  const double way = (middle(component(to, face.axis)) - face.height) / middle(component(ray, face.axis));
  Point from = numbers<Interval>(face.corners[0]);
  for (const int axis : {(face.axis + 1) % 3, (face.axis + 2) % 3}) {
    const double at = middle(component(to, axis)) - way * middle(component(ray, axis)),
                 lo = component(face.corners[0], axis), hi = component(face.corners[2], axis);
    // No number if the beam runs along the face.
    component(from, axis) = Interval(at >= lo ? std::min(at, hi) : lo);
  }
  return from;
}

}  // namespace provis::offset
