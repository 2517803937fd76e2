#pragma once
// Viewpoints that lie on what blocks the view.

#include "provis/scene.hpp"

namespace provis {

/// Whether the point lies on an occluding triangle (closed): decided exactly.
bool on_occluder(const Scene& scene, const Vec3d& p);

}  // namespace provis
