#pragma once
// One canonical witness for each primitive of R10°.

#include "src/segment/blocked.hpp"
#include "src/segment/cluster_tree.hpp"
#include "src/segment/tally.hpp"

namespace provis {

/// In id order. Each is a ray along a pixel's centre from a dyadic moment inside the primitive's first
/// glimpse.
///
/// Throws:     Error::internal for a glimpse that shows nothing; Error::cancelled
std::vector<Witness> make_witnesses(const Scene& scene, const SegmentView& view, const ClusterTree& tree,
                                    const BlockedTimes& blocked,
                                    const std::map<PrimitiveId, FrameGlimpse>& glimpses,
                                    const Context& context);

}  // namespace provis
