#pragma once
// Whether a point has three finite coordinates.

#include <cmath>

#include "provis/vec3.hpp"

namespace provis {

inline bool finite(const Vec3d& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

}  // namespace provis
