#pragma once
// Three coordinates with one certified radius: what the hot sign test works on.

#include <algorithm>
#include <cmath>

#include "predicates/ball.hpp"
#include "provis/vec3.hpp"

namespace provis {

/// Vectors in which more than this could appear are never certain: the product of two that are smaller does
/// not overflow, and no error that is lost to underflow grows past underflow_bound (ERRORS.md, 2).
inline constexpr double size_bound = 0x1p400;

/// A float64 vector; every component lies within `radius` of the true one, and `size` is the largest
/// magnitude among the components. The radius is infinite where nothing is known; then the size means
/// nothing.
struct Approx {
  Vec3d v;
  double size = 0, radius = 0;
};

inline double largest(const Vec3d& v) { return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}); }

/// The only way to an Approx with a radius. A NaN radius fails the comparison; a NaN component comes with an
/// infinite radius (ERRORS.md, 2).
inline Approx approximate(const Vec3d& v, double radius) {
  const double size = largest(v);
  return {v, size, size + radius < size_bound ? radius : HUGE_VAL};
}

inline Approx approximate(const Vec3<Ball>& b) {
  return approximate({b.x.value, b.y.value, b.z.value}, std::max({b.x.radius, b.y.radius, b.z.radius}));
}

/// Plain doubles claim no error at all.
inline Approx approximate(const Vec3d& v) { return {v, largest(v), 0}; }

/// A vector on which many functionals are evaluated, with what its part of the error bound amounts to.
struct ApproxDirection {
  Vec3d v;
  double per_size = 0;    ///< bound contributed per unit of the functional's size
  double per_radius = 0;  ///< bound contributed per unit of the functional's radius
};

/// Constants: ERRORS.md, 4. Three products and two sums of magnitude at most size·size lose less than
/// 9·2^-52 of it; 2^-20 makes up for the rounding of the bound itself.
inline ApproxDirection prepare(const Approx& a) {
  constexpr double slack = 1 + 0x1p-20;
  return {a.v, (3 * a.radius + 9 * unit_roundoff * a.size) * slack, 3 * (a.size + a.radius) * slack};
}

/// The cross product of two approximate vectors (ERRORS.md, 5): 5·2^-52 covers two products and their
/// difference, each of magnitude at most size·size.
inline Approx cross(const Approx& a, const Approx& b) {
  constexpr double slack = 1 + 0x1p-20;
  const Vec3d v = cross(a.v, b.v);
  const double inherited = 2 * (a.size * b.radius + a.radius * (b.size + b.radius));
  return approximate(v, (inherited + 5 * unit_roundoff * a.size * b.size) * slack + underflow_bound);
}

/// The value of a functional at a direction, and the bound on its error.
struct FilteredValue {
  double value, bound;
};

inline FilteredValue evaluate(const Approx& functional, const ApproxDirection& at) {
  return {dot(functional.v, at.v),
          functional.size * at.per_size + functional.radius * at.per_radius + underflow_bound};
}

}  // namespace provis
