#pragma once
// Points between the points of the input.

#include "predicates/interval.hpp"
#include "predicates/rational.hpp"
#include "provis/vec3.hpp"

namespace provis::lod {

using Point = Vec3<Rational>;

/// Float64 numbers around it.
inline Interval enclosed(const Rational& x) { return Interval(CGAL::to_interval(x)); }
inline Vec3<Interval> enclosed(const Point& p) { return {enclosed(p.x), enclosed(p.y), enclosed(p.z)}; }

inline Vec3d rounded(const Point& p) {
  return {CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)};
}

}  // namespace provis::lod
