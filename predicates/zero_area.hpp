#pragma once
// Whether a triangle has exactly zero area.

#include "provis/vec3.hpp"

namespace provis {

/// Whether a, b and c lie on one line (or coincide).
///
/// Guarantee:  exact for all finite float64 coordinates
/// Degenerate: three equal points are on one line
bool zero_area(const Vec3d& a, const Vec3d& b, const Vec3d& c);

}  // namespace provis
