#pragma once
// The parts of a face on which no occluder lies.

#include <vector>

#include "provis/scene.hpp"
#include "src/offset/face.hpp"

namespace provis {

bool has_area(const offset::Face& face);

/// An occluder in the plane of a face blocks the rays that start on it (R9), which a parallel view from the
/// face does not see: there its distance is zero (R6). Rays are free of that in these parts, which are found
/// by halving the face.
///
/// Input:      halvings: how often, at most; what is not free then is left out
/// Returns:    the whole face where no occluder lies in its plane and overlaps it
/// Guarantee:  exact: no occluder that lies in the plane overlaps a part in positive area
std::vector<offset::Face> free_parts(const Scene& scene, const offset::Face& face, int halvings);

}  // namespace provis
