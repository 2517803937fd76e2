#include "src/point/area.hpp"

#include "predicates/exact_number.hpp"

namespace provis {

WindowPoint window_point(const ViewGeometry& g, const Direction& ray) {
  using N = ExactNumber;
  const Vec3<N> q = evaluate<N>(g, ray);
  const Vec3<N> c = frame_center<N>(g), r = project_vector<N>(g, g.right), u = project_vector<N>(g, g.up);
  const Rational w = static_cast<Rational>(dot(q, cross(r, u)));
  return {static_cast<Rational>(dot(q, cross(u, c))) / w, static_cast<Rational>(dot(q, cross(c, r))) / w};
}

std::vector<WindowPoint> window_polygon(const ViewGeometry& g, const Cell& cell) {
  std::vector<WindowPoint> polygon;
  for (const Direction& v : cell.vertices) polygon.push_back(window_point(g, v));
  return polygon;
}

Rational area(const std::vector<WindowPoint>& p) {
  Rational doubled = 0;
  for (std::size_t k = 1; k + 1 < p.size(); ++k)
    doubled += (p[k].x - p[0].x) * (p[k + 1].y - p[0].y) - (p[k].y - p[0].y) * (p[k + 1].x - p[0].x);
  return (doubled < 0 ? -doubled : doubled) / 2;
}

}  // namespace provis
