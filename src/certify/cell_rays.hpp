#pragma once
// Which rays belong to a view cell.

#include "provis/cell.hpp"
#include "src/certify/exact_ray.hpp"

namespace provis {

/// Whether the ray starts in the closed box and leads into the closed window, if there is one.
bool belongs(const ExactRay& ray, const ViewCell& cell);

}  // namespace provis
