#include "src/region/contact.hpp"

#include <algorithm>
#include <array>

#include "predicates/exact_number.hpp"
#include "predicates/formulas.hpp"
#include "predicates/plane_side.hpp"
#include "predicates/zero_area.hpp"
#include "src/scene/separation.hpp"

namespace provis {
namespace {

using N = ExactNumber;

/// A triangle and the cell.
class Touch {
 public:
  Touch(const Scene& scene, std::size_t t, const ViewCell& cell)
      : p_{scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)},
        one_sided_(scene.triangle_flags()[t] & single_sided),
        cell_(cell),
        pair_(p_, {cell.lower, cell.upper}) {}

  bool unseen() const;
  bool meets_interior() const;
  bool shows_inside() const;
  bool shows_on_a_face() const;

 private:
  Vec3<N> normal() const {
    const Vec3<N> o = numbers<N>(p_[0]);
    return cross(numbers<N>(p_[1]) - o, numbers<N>(p_[2]) - o);
  }
  double least(int axis) const {
    return std::min({component(p_[0], axis), component(p_[1], axis), component(p_[2], axis)});
  }
  double greatest(int axis) const {
    return std::max({component(p_[0], axis), component(p_[1], axis), component(p_[2], axis)});
  }
  bool overlaps_face(int axis) const;
  /// Whether some direction of the window has a positive product with the vector.
  bool some_direction_along(const Vec3<N>& v) const;

  std::array<Vec3d, 3> p_;
  bool one_sided_;
  const ViewCell& cell_;
  TriangleAndBox pair_;
};

/// Every corner of the cell lies in the triangle's plane, or behind a triangle that has no back.
bool Touch::unseen() const {
  return std::all_of(pair_.corners.begin(), pair_.corners.end(), [&](const Vec3d& c) {
    const Sign s = plane_side(p_[0], p_[1], p_[2], c);
    return s == Sign::zero || (one_sided_ && s == Sign::negative);
  });
}

// Of two convex bodies one is open: they are disjoint iff a plane separates them weakly.
bool Touch::meets_interior() const {
  for (int axis = 0; axis < 3; ++axis)
    if (!(least(axis) < component(cell_.upper, axis) && greatest(axis) > component(cell_.lower, axis)) ||
        !(component(cell_.lower, axis) < component(cell_.upper, axis)))
      return false;
  return !pair_.separated(Gap::touch);
}

bool Touch::some_direction_along(const Vec3<N>& v) const {
  if (!cell_.window) return true;
  const Frame& f = *cell_.window;
  for (const double x : {f.window.x0, f.window.x1})
    for (const double y : {f.window.y0, f.window.y1}) {
      const Vec3<N> d = numbers<N>(f.forward) + N(x) * numbers<N>(f.right) + N(y) * numbers<N>(f.up);
      if (sign_of(dot(v, d)) == Sign::positive) return true;
    }
  return false;
}

/// From the inside of the cell both sides can be reached; a front is seen against its normal.
bool Touch::shows_inside() const { return !one_sided_ || some_direction_along(-normal()); }

/// The triangle lies in a plane across the axis: whether it overlaps the box there in positive area. The same
/// separation in two dimensions.
bool Touch::overlaps_face(int axis) const {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  for (const int k : {i, j})
    if (!(least(k) < component(cell_.upper, k) && greatest(k) > component(cell_.lower, k))) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d &a = p_[k], &b = p_[(k + 1) % 3];
    const Gap gap = pair_.along([&]<class T>() {
      Vec3<T> v{T(0.0), T(0.0), T(0.0)};
      component(v, i) = T(component(b, j)) - T(component(a, j));
      component(v, j) = T(component(a, i)) - T(component(b, i));
      return v;
    });
    if (gap >= Gap::touch) return false;
  }
  return true;
}

bool Touch::shows_on_a_face() const {
  for (int axis = 0; axis < 3; ++axis)
    if (!(component(cell_.lower, axis) < component(cell_.upper, axis))) return false;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true}) {
      const double h = component(upper ? cell_.upper : cell_.lower, axis);
      if (least(axis) != h || greatest(axis) != h || !overlaps_face(axis)) continue;
      Vec3<N> out{N(0), N(0), N(0)};
      component(out, axis) = N(upper ? 1 : -1);
      const bool front_inside = sign_of(dot(normal(), out)) == Sign::negative;
      if ((!one_sided_ || front_inside) && some_direction_along(out)) return true;
    }
  return false;
}

}  // namespace

Contact contact(const Scene& scene, std::size_t t, const ViewCell& cell) {
  if (zero_area(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2))) return Contact::hidden;
  const Touch touch(scene, t, cell);
  if ((touch.meets_interior() && touch.shows_inside()) || touch.shows_on_a_face()) return Contact::visible;
  return touch.unseen() ? Contact::hidden : Contact::apart;
}

}  // namespace provis
