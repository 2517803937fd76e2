#pragma once
// The camera offset space of a view cell: what is not proven to be hidden from it.

#include "provis/cell.hpp"
#include "src/scene/progress_meter.hpp"

namespace provis::offset {

/// What to answer for each triangle.
struct UpperSet {
  std::vector<char> reached;  ///< by id: of those asked for, those that are not proven hidden
  OffsetStats stats;
};

/// Looks outward through the faces of the cell, in every direction of its window, at the triangles asked for.
///
/// Input:      wanted: by id; all triangles occlude. refinements: how often a beam of one pixel is halved
///             further, in viewpoints or directions, before what it may show is kept
/// Guarantee:  conservative: a wanted triangle that is not reached is hit first by no ray out of the cell,
/// but
///             for a set of measure zero. Triangles that meet the cell (contact.hpp) are not for this
///             function
/// Throws:     Error::cancelled
UpperSet reach(const Scene& scene, const ViewCell& cell, const std::vector<char>& wanted,
               const PixelGrid& pixels, int refinements, const Context& context, ProgressMeter& meter);

}  // namespace provis::offset
