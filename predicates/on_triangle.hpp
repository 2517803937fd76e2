#pragma once
// Whether a point lies on a closed triangle.

#include "provis/vec3.hpp"

namespace provis {

/// Guarantee:  exact for all finite float64 coordinates
/// Degenerate: a triangle of zero area holds no point (R3); corners and edges belong to the triangle
bool on_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c);

}  // namespace provis
