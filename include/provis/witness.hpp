#pragma once
// Checking that witnesses prove what they claim.

#include "provis/cell.hpp"
#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/segment.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// Re-checks every witness of a set against all triangles of the scene, from the coordinates alone.
///
/// Input:      set: as an engine or a file gave it, with witnesses
/// Returns:    the number of witnesses, each of which holds (R11)
/// Guarantee:  exact: a witness passes iff its ray belongs to the view, hits the primitive in its relative
///             interior on a visible side, and every occluder outside its plane misses the closed segment
/// Degenerate: an occluder whose plane holds the eye has no hits (R6)
/// Throws:     Error::rejected naming the primitive and the reason; a visible primitive without a witness;
///             Error::cancelled
/// Cost:       about O(F log F + w log F), w witnesses; parallel
std::size_t verify_witnesses(const Scene& scene, const PointView& view, const VisibleSet& set,
                             const Context& context = {});

/// The same for the answer of a cell.
///
/// Input:      result: as visible_from_cell gave it
/// Returns:    the number of witnesses, each of which holds (R11)
/// Guarantee:  exact: a witness passes iff it starts in the closed cell on no occluder, leads into the window
///             if there is one, and proves what it claims as above
/// Degenerate: a cell of one point is that point, which may lie on an occluder (R7)
/// Throws:     Error::rejected naming the primitive and the reason; a visible primitive without a witness
///             that is neither in result.unwitnessed nor in result.boundary; Error::cancelled
std::size_t verify_witnesses(const Scene& scene, const ViewCell& cell, const CellSet& result,
                             const Context& context = {});

/// The same for a query along a segment, of which the primitives of `boundary` have no witness.
///
/// Guarantee:  exact, as above, where a ray belongs to the view iff it starts on the segment, runs through
/// the
///             centre of a pixel (R8) and starts on no occluder
/// Degenerate: on a segment of length zero a viewpoint may lie on an occluder, as for a point (R7)
std::size_t verify_witnesses(const Scene& scene, const SegmentView& view, const SegmentSet& set,
                             const Context& context = {});

}  // namespace provis
