#pragma once
// The triangles that can matter in one part of a window: oriented, and as functions of window coordinates.

#include <span>
#include <vector>

#include "predicates/signs.hpp"
#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "src/point/window_function.hpp"

namespace provis {

/// A triangle that has hits: the cone in which the three edge lines are positive.
struct Facet {
  PrimitiveId id = 0;
  bool occludes = true;
  bool cut = false;  ///< reaches behind the window of an eye at infinity: the front line bounds it too
  Corners corners;   ///< in the order in which at_eye > 0
  std::uint32_t points[3] = {no_id, no_id, no_id};  ///< indices into Facets::positions
  Window box;                                       ///< holds all hits; infinite where it is not known
  WindowFunction inside[3];                         ///< edges: positive inside
  WindowFunction depth;
};

struct Facets {
  std::vector<Facet> facets;            ///< in id order
  std::vector<const Vec3d*> positions;  ///< equal positions are one
};

/// Orients the triangles, and leaves out what can have no hit: zero area, edge-on, seen from a side it does
/// not have, behind the window of an eye at infinity, certainly outside the window. Plain doubles claim no
/// error in any function.
///
/// Requires:   ids ascending
template <Arithmetic A>
Facets make_facets(Signs<A>& signs, const Scene& scene, const Window& window,
                   std::span<const PrimitiveId> ids);

/// All triangles of the scene, in parallel.
template <Arithmetic A>
Facets make_facets(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                   const Context& context, SignCounts& counts);

}  // namespace provis
