#pragma once
// How much of the exact set, and of the image, another set holds.

#include <vector>

#include "provis/scene.hpp"
#include "provis/segment.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// A part of the image: shown where every primitive that is seen there belongs to the set.
struct ImagePart {
  double area = 0;
  std::vector<PrimitiveId> visible;
};

/// The cells of the exact subdivision; together they are the window. Takes what it needs of each cell.
std::vector<ImagePart> parts_of(std::vector<SubdivisionCell>&& cells);

/// Where there is no subdivision: each visible triangle with the area of its image in the window, parts that
/// are hidden included, in float64.
std::vector<ImagePart> projected_parts(const Scene& scene, const PointView& view,
                                       const std::vector<Status>& exact);

/// Along segments: each visible triangle with the time for which it is seen, summed over pixels.
std::vector<ImagePart> seen_parts(const std::vector<Seen>& seen);

struct SetScore {
  std::size_t wrong_in = 0;   ///< in the set, though hidden
  std::size_t wrong_out = 0;  ///< visible, and not in the set
  double set_missed = 0;      ///< wrong_out as a share of all that are visible
  double area_missed = 0;     ///< share of the area of the parts that are not shown; 0 if there are none
};

/// exact: of a cell, what is known of it; the shares are those of what is known to be visible.
///
/// Requires:   both of the same scene
SetScore score(const std::vector<Status>& set, const std::vector<Status>& exact,
               const std::vector<ImagePart>& parts);

/// What all proofs together say of a cell: visible or hidden where one does, else undecided.
///
/// Throws:     Error::internal where two contradict each other
/// Requires:   one or more, all of the same scene
std::vector<Status> united(const std::vector<const std::vector<Status>*>& proofs);

/// How far the upper set of a cell goes beyond what is known to be visible.
struct SetExcess {
  std::size_t possible = 0;  ///< not hidden
  std::size_t beyond = 0;    ///< of these, not known to be visible
  double share = 0;          ///< beyond, by the number of those known to be visible
};

SetExcess excess(const std::vector<Status>& upper, const std::vector<Status>& known);

}  // namespace provis
