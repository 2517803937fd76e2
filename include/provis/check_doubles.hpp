#pragma once
// How often plain float64 arithmetic is wrong on the way to its answer.

#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

struct SegmentSet;
struct SegmentView;

/// What Arithmetic::doubles answers, with every sign on its way decided exactly too.
///
/// Input:      scene: F triangles; view: eye and frames in world units
/// Returns:    status per primitive, size F, and the same stats.signs.decided as without the check; in
///             stats.signs.wrong, per predicate, how many of these signs were not the exact ones
/// Guarantee:  none for the set (Guarantee::sampled); the counts are exact
/// Requires:   check(view) passes
/// Degenerate: a sign that is zero and was taken as not zero is wrong, and the other way round
/// Throws:     Error::cancelled, Error::unsupported (spheres)
/// Cost:       several times that of plain doubles; parallel; same answer for any thread count
VisibleSet check_doubles(const Scene& scene, const PointView& view, const Context& context = {});

/// The same along a segment, by SegmentEngine::fast.
///
/// Returns:    as visible_from_segment, with stats.signs.wrong per predicate. Where float64 finds an interval
/// of
///             time in one go, that counts as one sign of Predicate::motion, wrong if the interval is another
/// Guarantee:  none for the set (Guarantee::sampled); the counts are exact
/// Cost:       a hundred times that of plain doubles
SegmentSet check_doubles(const Scene& scene, const SegmentView& view, const Context& context = {});

}  // namespace provis
