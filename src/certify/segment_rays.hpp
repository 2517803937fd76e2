#pragma once
// Which rays belong to a view along a segment.

#include "provis/segment.hpp"
#include "src/certify/exact_ray.hpp"

namespace provis {

/// Whether the ray starts on the segment and runs through the centre of a pixel of one of the frames (R8).
bool belongs(const ExactRay& ray, const SegmentView& view);

}  // namespace provis
