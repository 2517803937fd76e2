#pragma once
// Planes between a triangle and a box: two convex bodies are apart iff one across an axis, along the
// triangle, or across an axis and an edge lies between them. A RoundUp guard must be alive.

#include <algorithm>
#include <array>

#include "predicates/certain_sign.hpp"
#include "predicates/formulas.hpp"
#include "src/scene/box_tree.hpp"

namespace provis {

/// Between the extents of two bodies along some vector.
enum class Gap {
  none,    ///< they overlap, or the vector has length zero
  touch,   ///< at most an end in common
  strict,  ///< nothing in common
};

struct TriangleAndBox {
  std::array<Vec3d, 3> triangle;
  std::array<Vec3d, 8> corners;

  TriangleAndBox(const std::array<Vec3d, 3>& t, const Box& box) : triangle(t), corners(corners_of(box)) {}

  /// Exact. vector: a template over the number type, without arguments.
  template <class Vector>
  Gap along(const Vector& vector) const;

  /// Whether there is such a gap along the normal, or across an axis and an edge. Along the axes themselves
  /// it shows in the coordinates.
  bool separated(Gap at_least) const;
};

template <class Vector>
Gap TriangleAndBox::along(const Vector& vector) const {
  bool below = false, above = false, level = false;
  for (const Vec3d& p : triangle)
    for (const Vec3d& c : corners) {
      const Sign s = certain_sign(
          [&]<class N>() { return dot(vector.template operator()<N>(), numbers<N>(p) - numbers<N>(c)); });
      below = below || s == Sign::negative;
      above = above || s == Sign::positive;
      level = level || s == Sign::zero;
      if (below && above) return Gap::none;
    }
  if (!below && !above) return Gap::none;
  return level ? Gap::touch : Gap::strict;
}

inline bool TriangleAndBox::separated(Gap at_least) const {
  const Vec3d &a = triangle[0], &b = triangle[1], &c = triangle[2];
  if (along([&]<class N>() { return cross(numbers<N>(b) - numbers<N>(a), numbers<N>(c) - numbers<N>(a)); }) >=
      at_least)
    return true;
  for (std::size_t k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const Gap gap = along([&]<class N>() {
        Vec3<N> unit{N(0.0), N(0.0), N(0.0)};
        component(unit, axis) = N(1.0);
        return cross(unit, numbers<N>(triangle[(k + 1) % 3]) - numbers<N>(triangle[k]));
      });
      if (gap >= at_least) return true;
    }
  return false;
}

}  // namespace provis
