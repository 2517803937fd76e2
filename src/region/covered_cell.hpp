#pragma once
// Flat cells that lie on occluders.

#include "provis/cell.hpp"
#include "provis/scene.hpp"

namespace provis {

/// Whether every point of the cell lies on an opaque triangle, so that it has no viewpoint (R9). Never of a
/// box with a volume.
///
/// Guarantee:  exact
bool lies_on_occluders(const Scene& scene, const ViewCell& cell);

}  // namespace provis
