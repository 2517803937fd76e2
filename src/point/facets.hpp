#pragma once
// A scene as seen through one frame: the triangles that can matter, oriented and projected.

#include <vector>

#include "predicates/signs.hpp"
#include "provis/context.hpp"
#include "provis/scene.hpp"

namespace provis {

/// An input point in the image.
struct ImagePoint {
  Direction direction;
  Sign side =
      Sign::positive;  ///< of the image: negative or zero where the point is not in front of the frame
};

/// A triangle that has hits: the cone in which the three edge lines are positive.
template <class Hot>
struct Facet {
  PrimitiveId id = 0;
  bool occludes = true;
  bool cut = false;  ///< reaches behind the window of an eye at infinity: the front line bounds it too
  Corners corners;
  std::uint32_t points[3] = {no_id, no_id, no_id};  ///< indices into Facets::points
  Line edges[3];                                    ///< positive inside
  Plane<Hot> plane;                                 ///< at_eye > 0
};

template <Arithmetic A>
struct Facets {
  using Hot = typename HotNumber<A>::type;

  std::vector<Facet<Hot>> facets;  ///< in id order
  std::vector<ImagePoint> points;
};

/// Orients every triangle, and leaves out what can have no hit in the frame: zero area, edge-on, seen from
/// a side it does not have, behind the window of an eye at infinity, certainly outside the window.
template <Arithmetic A>
Facets<A> make_facets(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                      const Context& context, SignCounts& counts);

}  // namespace provis
