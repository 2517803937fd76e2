#pragma once
// Points against the plane of a triangle.

#include "predicates/certain_sign.hpp"
#include "predicates/formulas.hpp"

namespace provis {

/// Positive on the side that the normal (b - a) x (c - a) points to.
template <class N>
N plane_height(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3<N>& p) {
  const Vec3<N> o = numbers<N>(a);
  return dot(cross(numbers<N>(b) - o, numbers<N>(c) - o), p - o);
}

/// Exact; a RoundUp guard must be alive.
inline Sign plane_side(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& p) {
  return certain_sign([&]<class N>() { return plane_height(a, b, c, numbers<N>(p)); });
}

}  // namespace provis
