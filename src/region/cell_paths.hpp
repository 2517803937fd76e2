#pragma once
// Segments in a cell along which is looked continuously.

#include <utility>
#include <vector>

#include "provis/cell.hpp"

namespace provis {

/// The edges and the diagonals of the box, each once and none of length zero.
std::vector<std::pair<Vec3d, Vec3d>> edges_and_diagonals(const ViewCell& cell);

}  // namespace provis
