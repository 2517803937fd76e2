#pragma once
// Where a ray meets a triangle, over any number type.

#include "predicates/formulas.hpp"

namespace provis {

/// Where a ray meets a triangle's plane and how it passes the edges. With a, b, c relative to the origin:
/// passes[k] = det[p_k, p_k+1, direction], along = n·direction = their sum, reach = n·a. The hit lies at
/// reach/along; it is inside where all passes have the sign of along.
template <class N>
struct RayHit {
  N passes[3], along, reach;
};

template <class N>
RayHit<N> ray_hit(const Vec3<N>& origin, const Vec3<N>& direction, const Vec3d& a, const Vec3d& b,
                  const Vec3d& c) {
  const Vec3<N> p = numbers<N>(a) - origin, q = numbers<N>(b) - origin, r = numbers<N>(c) - origin;
  const Vec3<N> n = cross(numbers<N>(b) - numbers<N>(a), numbers<N>(c) - numbers<N>(a));
  return {{dot(cross(p, q), direction), dot(cross(q, r), direction), dot(cross(r, p), direction)},
          dot(n, direction),
          dot(n, p)};
}

}  // namespace provis
