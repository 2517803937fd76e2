#pragma once
// The answers along several segments as one.

#include "provis/segment.hpp"

namespace provis {

/// Adds what another segment showed: visible is what either shows, boundary what neither proves, and of two
/// witnesses the first stays. Times add up, the measures too.
void unite(SegmentSet& all, SegmentSet&& more);

}  // namespace provis
