#pragma once
// A part of a triangle that is to be hidden, and how occluders and their edges lie to it.

#include "src/offset/fusion.hpp"

namespace provis::offset {

struct Target {
  const Facet& facet;
  const Polygon& polygon;  ///< the part
};

/// A point of the polygon's relative interior.
Point inner_point(const Polygon& p);

/// All of the part lies on the far side of the occluder's plane or in it, and not all of it in it.
bool lies_beyond(const Facet& occluder, const Target& target);
/// The same for the whole triangle.
bool lies_beyond(const Facet& occluder, const Facet& facet);

bool boxes_apart(const Facet& occluder, const Target& target);

/// False only if no segment from inside the face to the inside of the part meets the edge on its way.
bool may_be_crossed(const Mesh::Edge& edge, const Face& face, const Target& target);

}  // namespace provis::offset
