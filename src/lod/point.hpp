#pragma once
// Points between the points of the input.

#include "predicates/interval.hpp"
#include "predicates/rational.hpp"
#include "provis/vec3.hpp"

namespace provis::lod {

using Point = Vec3<Rational>;

/// Inside of a triangle, and the nearer to its last corner the smaller the share of the others; above 0, up
/// to a quarter. Powers of two keep the numbers short.
inline Point inner_point(const Point& a, const Point& b, const Point& c, const Rational& share = 0.25) {
  return share * (a + b) + (Rational(1) - Rational(2) * share) * c;
}

/// Float64 numbers around it.
inline Interval enclosed(const Rational& x) { return Interval(CGAL::to_interval(x)); }
inline Vec3<Interval> enclosed(const Point& p) { return {enclosed(p.x), enclosed(p.y), enclosed(p.z)}; }

inline Vec3d rounded(const Point& p) {
  return {CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)};
}

}  // namespace provis::lod
