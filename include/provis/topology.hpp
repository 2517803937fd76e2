#pragma once
// How the triangles of a scene join: edges, holes and doubles, by exact position.

#include <cstddef>

#include "provis/context.hpp"
#include "provis/scene.hpp"

namespace provis {

/// Counts over the triangles that are not degenerate (R3). Corners are compared by position, not by index:
/// three equal coordinates, where -0 equals 0.
struct Topology {
  /// Triangles with the same three corner positions, in any rotation or winding, as one of smaller id: of k
  /// that coincide, k - 1. Flags do not matter.
  std::size_t duplicate_triangles = 0;
  std::size_t edges = 0;       ///< different pairs of positions that are an edge of any triangle
  std::size_t open_edges = 0;  ///< edges of exactly one triangle; the edges of a duplicate have two
};

/// Input:      scene: F triangles, V vertices
/// Guarantee:  exact
/// Degenerate: triangles of zero area are passed over; where three or more triangles meet, the edge is not
/// open Throws:     Error::cancelled; Error::unsupported for more than 2^32 - 1 vertices Cost:       about
/// O(F + V), some 24 bytes per triangle and 15 per vertex beside the scene; parallel; same
///             answer for any thread count
Topology topology(const Scene& scene, const Context& context = {});

}  // namespace provis
