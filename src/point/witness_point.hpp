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

/// A dyadic point strictly inside the cell, a function of the cell and the attempt alone. A line holds the
/// points of fewer attempts than the cell has corners, up to the rounding to dyadic numbers.
WitnessPoint interior_point(const ViewGeometry& g, const Cell& cell, std::size_t attempt);

/// The ray through the point, in the coordinates on which lines are functionals.
Vec3<ExactNumber> exact_ray(const ViewGeometry& g, const WitnessPoint& point);

Sign exact_side(const ViewGeometry& g, const Side& side, const Vec3<ExactNumber>& ray);

/// The witness as the ray from the eye (or from the window, for an eye at infinity) through the point.
Witness make_witness(PrimitiveId primitive, const ViewGeometry& g, const WitnessPoint& point);

}  // namespace provis
