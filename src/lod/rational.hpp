#pragma once
// Points between the points of the input: exact numbers with division.

#include <CGAL/Gmpq.h>

#include "predicates/interval.hpp"
#include "predicates/sign.hpp"
#include "provis/vec3.hpp"

namespace provis::lod {

using Rational = CGAL::Gmpq;
using Point = Vec3<Rational>;

inline Sign sign_of(const Rational& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }

/// Float64 numbers around it.
inline Interval enclosed(const Rational& x) { return Interval(CGAL::to_interval(x)); }
inline Vec3<Interval> enclosed(const Point& p) { return {enclosed(p.x), enclosed(p.y), enclosed(p.z)}; }

inline Vec3d rounded(const Point& p) {
  return {CGAL::to_double(p.x), CGAL::to_double(p.y), CGAL::to_double(p.z)};
}

}  // namespace provis::lod
