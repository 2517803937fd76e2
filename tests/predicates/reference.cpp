#include "tests/predicates/reference.hpp"

namespace provis::test {
namespace {

RationalVector scaled(const Rational& s, const RationalVector& v) { return {s * v[0], s * v[1], s * v[2]}; }

RationalVector sum(const RationalVector& a, const RationalVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

Rational magnitude(const Rational& q) { return q < 0 ? Rational(-q) : q; }

Rational sign_number(const Rational& q) { return Rational(static_cast<int>(rational_sign(q))); }

}  // namespace

RationalVector rational(const Vec3d& v) { return {Rational(v.x), Rational(v.y), Rational(v.z)}; }

RationalVector operator-(const RationalVector& a, const RationalVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

RationalVector cross_product(const RationalVector& a, const RationalVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Rational dot_product(const RationalVector& a, const RationalVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Rational determinant(const RationalVector& a, const RationalVector& b, const RationalVector& c) {
  return dot_product(a, cross_product(b, c));
}

Sign rational_sign(const Rational& q) { return q > 0 ? Sign::positive : q < 0 ? Sign::negative : Sign::zero; }

bool is_zero(const RationalVector& v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; }

Reference::Reference(const ViewGeometry& g)
    : g_(g),
      eye_(rational(g.eye)),
      right_(rational(g.right)),
      up_(rational(g.up)),
      forward_(rational(g.forward)),
      det_(determinant(forward_, right_, up_)),
      hand_(sign_number(det_)) {}

// Cramer: world = ray[0] forward + ray[1] right + ray[2] up, times the positive |det|.
RationalVector Reference::window_ray(const RationalVector& q) const {
  return {hand_ * determinant(q, right_, up_), hand_ * determinant(forward_, q, up_),
          hand_ * determinant(forward_, right_, q)};
}

Reference::Image Reference::image(const Vec3d& p) const {
  const RationalVector c = window_ray(rational(p) - eye_);
  if (g_.at_infinity) return {{magnitude(det_), c[1], c[2]}, c[0]};
  return {c, c[0]};
}

/// Solves for the window coordinates whose sheared image is given.
RationalVector Reference::unsheared(const RationalVector& s) const {
  const RationalVector d = rational(g_.shear_direction);
  const int i = g_.axes[0], j = g_.axes[1], k = g_.axes[2];
  const auto at = [](const RationalVector& v, int axis) { return v[static_cast<std::size_t>(axis)]; };
  const auto column = [&](const RationalVector& v) {
    return RationalVector{at(v, i) * at(d, k) - at(v, k) * at(d, i),
                          at(v, j) * at(d, k) - at(v, k) * at(d, j), 0};
  };
  const RationalVector origin{0, 0, at(d, k)}, x = column(right_), y = column(up_);
  const Rational hand = sign_number(determinant(origin, x, y));
  return {hand * determinant(s, x, y), hand * determinant(origin, s, y), hand * determinant(origin, x, s)};
}

RationalVector Reference::ray(const Direction& d) const {
  RationalVector r;
  switch (d.kind) {
    case DirectionKind::point:
      r = image(*d.point).ray;
      break;
    case DirectionKind::window:
      return {1, Rational(d.numbers.x), Rational(d.numbers.y)};
    case DirectionKind::crossing:
      r = scaled(hand_, cross_product(functional(*d.lines[0]), functional(*d.lines[1])));
      break;
    case DirectionKind::given:
      return g_.at_infinity ? unsheared(rational(d.numbers)) : window_ray(rational(d.numbers));
  }
  return d.negated ? scaled(-1, r) : r;
}

/// Interpolates the depth of an eye at infinity, or 1/distance of a finite one: 1 at all three corners.
RationalVector Reference::depth_functional(const Corners& t) const {
  const Image a = image(*t.p[0]), b = image(*t.p[1]), c = image(*t.p[2]);
  const Rational da = g_.at_infinity ? a.depth : 1, db = g_.at_infinity ? b.depth : 1,
                 dc = g_.at_infinity ? c.depth : 1;
  const RationalVector n =
      sum(sum(scaled(da, cross_product(b.ray, c.ray)), scaled(db, cross_product(c.ray, a.ray))),
          scaled(dc, cross_product(a.ray, b.ray)));
  return scaled(1 / determinant(a.ray, b.ray, c.ray), n);
}

RationalVector Reference::functional(const Line& l) const {
  const Rational at = Rational(l.at), s = l.negated ? -1 : 1;
  switch (l.kind) {
    case LineKind::edge:
      return scaled(hand_, cross_product(image(*l.first.p[0]).ray, image(*l.first.p[1]).ray));
    case LineKind::x_border:
      return scaled(s, {-at, 1, 0});
    case LineKind::y_border:
      return scaled(s, {-at, 0, 1});
    case LineKind::image:
      return {1, 0, 0};
    // Nearer means a larger inverse distance, but a smaller depth.
    case LineKind::depth:
      return g_.at_infinity ? depth_functional(l.second) - depth_functional(l.first)
                            : depth_functional(l.first) - depth_functional(l.second);
    case LineKind::front:
      return depth_functional(l.first);
  }
  return {};
}

Sign Reference::side(const Line& line, const Direction& direction) const {
  return rational_sign(dot_product(functional(line), ray(direction)));
}

Sign Reference::facing(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
  const RationalVector p = rational(a), q = rational(b), r = rational(c);
  return rational_sign(g_.at_infinity ? determinant(q - p, r - p, forward_)
                                      : determinant(p - eye_, q - eye_, r - eye_));
}

Sign Reference::front(const Vec3d& p) const { return rational_sign(image(p).depth); }

bool Reference::coplanar(const Corners& a, const Corners& b) {
  const RationalVector o = rational(*a.p[0]), u = rational(*a.p[1]) - o, v = rational(*a.p[2]) - o;
  for (const Vec3d* p : b.p)
    if (determinant(u, v, rational(*p) - o) != 0) return false;
  return true;
}

}  // namespace provis::test
