#include "src/point/fragment.hpp"

namespace provis {

Vec3d middle_of_fragment(const Facet& f, const Window& w) {
  Polygon polygon({std::max(w.x0, f.box.x0), std::min(w.x1, f.box.x1), std::max(w.y0, f.box.y0),
                   std::min(w.y1, f.box.y1)});
  for (const WindowFunction& e : f.inside) polygon = polygon.clipped(e, 1);
  if (f.cut) polygon = polygon.clipped(f.depth, -1);
  const PolygonCorner at = polygon.middle();
  return {at.x, at.y, 0};
}

}  // namespace provis
