#pragma once
// Exact window coordinates of a ray on which something is seen.

#include "predicates/exact_number.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"
#include "src/point/cell.hpp"

namespace provis {

/// Dyadic window coordinates.
struct WitnessPoint {
  ExactNumber x, y;
};

/// A dyadic point strictly inside the cell, a function of the cell alone.
WitnessPoint interior_point(const ViewGeometry& g, const Cell& cell);

/// The witness as the ray from the eye (or from the window, for an eye at infinity) through the point.
Witness make_witness(PrimitiveId primitive, const ViewGeometry& g, const WitnessPoint& point);

}  // namespace provis
