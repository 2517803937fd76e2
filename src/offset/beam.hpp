#pragma once
// The rays of one rectangle of pixels, and what they may hit.

#include <boost/smart_ptr/intrusive_ptr.hpp>
#include <boost/smart_ptr/intrusive_ref_counter.hpp>

#include "src/offset/fusion.hpp"

namespace provis::offset {

/// A part of a triangle, shared by the lists of one thread.
struct CutPolygon : Polygon, boost::intrusive_ref_counter<CutPolygon, boost::thread_unsafe_counter> {
  explicit CutPolygon(const Polygon& p) : Polygon(p) {}
};

/// A triangle that rays of a beam may hit.
struct Entry {
  std::uint32_t facet = 0;
  bool wanted = false;                         ///< still to be decided; all others are here to occlude
  Failure failure = Failure::nothing_between;  ///< of the last attempt to hide it
  double near = 0, far = 0;                    ///< bounds on the depth of what lies in the beam
  boost::intrusive_ptr<const CutPolygon> cut;  ///< what lies in the beam; null for the whole triangle
};

/// What of the entry lies in its beam.
Polygon polygon_of(const Entry& entry, const Facet& facet);

/// Rays from a rectangle of viewpoints in a rectangle of directions.
struct Beam {
  Face face;  ///< the viewpoints: a face or a part of one
  Window directions;
  Shafts::Spaces spaces;
  Point viewpoint{0, 0, 0};  ///< inside the face
  Point ray{0, 0, 0};        ///< inside the directions

  Beam(const Face& viewpoints, const Raster& raster, const Shafts& shafts, const Window& window);

  /// A point of the face from which the middle direction, or one near it, leads to the point.
  Point viewpoint_towards(const Point& to) const;
};

}  // namespace provis::offset
