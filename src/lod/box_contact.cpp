#include "src/lod/box_contact.hpp"

#include <array>

#include "predicates/certain_sign.hpp"
#include "predicates/formulas.hpp"

namespace provis::lod {
namespace {

/// A triangle and the corners of a box, between which a plane is looked for.
struct Pair {
  std::array<Vec3d, 3> triangle;
  std::array<Vec3d, 8> corners;

  /// Whether all corners of the triangle lie strictly on one side of all those of the box, along an axis that
  /// is given over any number type.
  template <class Axis>
  bool separates(const Axis& axis) const {
    Sign first = Sign::zero;
    for (const Vec3d& p : triangle)
      for (const Vec3d& c : corners) {
        const Sign s = certain_sign(
            [&]<class N>() { return dot(axis.template operator()<N>(), numbers<N>(p) - numbers<N>(c)); });
        if (s == Sign::zero || (first != Sign::zero && s != first)) return false;
        first = s;
      }
    return true;
  }
};

template <class N>
Vec3<N> unit(int axis) {
  Vec3<N> v{N(0.0), N(0.0), N(0.0)};
  component(v, axis) = N(1.0);
  return v;
}

}  // namespace

// Two disjoint convex bodies are separated by a plane across an axis, along the triangle, or across an axis
// and an edge.
bool may_meet(const Box& box, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if (!meet(box, box_around(a, b, c))) return false;
  Pair pair{{a, b, c}, {}};
  for (std::size_t k = 0; k < pair.corners.size(); ++k)
    pair.corners[k] = {k & 1 ? box.upper.x : box.lower.x, k & 2 ? box.upper.y : box.lower.y,
                       k & 4 ? box.upper.z : box.lower.z};
  if (pair.separates(
          [&]<class N>() { return cross(numbers<N>(b) - numbers<N>(a), numbers<N>(c) - numbers<N>(a)); }))
    return false;
  for (std::size_t k = 0; k < 3; ++k)
    for (int axis = 0; axis < 3; ++axis)
      if (pair.separates([&]<class N>() {
            return cross(unit<N>(axis),
                         numbers<N>(pair.triangle[(k + 1) % 3]) - numbers<N>(pair.triangle[k]));
          }))
        return false;
  return true;
}

}  // namespace provis::lod
