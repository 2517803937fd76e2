#pragma once
// A part of a triangle that is to be hidden from a face, and how occluders and their edges lie to it.

#include "src/offset/fusion.hpp"
#include "src/scene/box_tree.hpp"

namespace provis::offset {

/// A point of the polygon's relative interior.
Point inner_point(const Polygon& p);

/// All of the polygon, a part of the facet, lies on the far side of the occluder's plane or in it, and not
/// all of it in it.
bool lies_beyond(const Facet& occluder, const Facet& facet, const Polygon& polygon);
/// The same for the whole triangle.
bool lies_beyond(const Facet& occluder, const Facet& facet);

class Target {
 public:
  /// All three must outlive it.
  Target(const Facet& facet, const Polygon& polygon, const Face& face);

  const Facet& facet() const { return facet_; }

  bool lies_beyond(const Facet& occluder) const { return offset::lies_beyond(occluder, facet_, polygon_); }
  /// The box around the occluder and that around the part do not meet.
  bool box_apart_from(const Facet& occluder) const;

  /// False only if no segment from inside the face to the inside of the part meets the edge on its way.
  bool may_meet(const Mesh::Edge& edge) const;

 private:
  bool passed_on_one_side(const Mesh::Edge& edge) const;

  const Facet& facet_;
  const Polygon& polygon_;
  const Face& face_;
  Box box_;                                                   ///< around the part
  std::array<std::array<Point, Polygon::most>, 4> segments_;  ///< from the face's corners to the part's
};

}  // namespace provis::offset
