#pragma once
// Viewpoints of a cell that lie on no occluder.

#include <vector>

#include "provis/cell.hpp"

namespace provis {

/// The cell's corners, pulled towards the centre where an occluder holds them, its centre, and `more` points
/// spread evenly; those on an occluder are left out, and so are repetitions.
///
/// Guarantee:  float64 points of the closed cell, on no opaque triangle (decided exactly); the same for the
///             same arguments
/// Source:     the points: M. Roberts, The unreasonable effectiveness of quasirandom sequences, 2018
std::vector<Vec3d> free_viewpoints(const Scene& scene, const ViewCell& cell, int more, std::uint64_t seed);

}  // namespace provis
