#include "src/point/fragment.hpp"

namespace provis {

Vec3d middle_of_fragment(const Facet& f, const Window& w) {
  Polygon polygon(intersection(f.box, w));
  for (const WindowFunction& e : f.inside) polygon = polygon.clipped(e, 1);
  if (f.cut) polygon = polygon.clipped(f.depth, -1);
  const PolygonCorner at = polygon.middle();
  return {at.x, at.y, 0};
}

}  // namespace provis
