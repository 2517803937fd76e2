#include "tests/support/facet.hpp"

#include <algorithm>
#include <cmath>

namespace provis::test {

FrameView::FrameView(const PointView& view, const Frame& frame, const CommonScale& scale)
    : scale_(scale),
      parallel_(view.projection == Projection::parallel),
      eye_(scale(view.eye)),
      right_(scale(frame.right)),
      up_(scale(frame.up)),
      forward_(scale(frame.forward)),
      window_(frame.window) {}

std::optional<Facet> FrameView::facet(const SceneArrays& scene, std::size_t t) const {
  const auto corner = [&](std::size_t k) { return scale_(scene.vertices[scene.triangles[t][k]]) - eye_; };
  const Corners at{corner(0), corner(1), corner(2)};
  bool from_front = false;
  std::optional<Facet> facet = parallel_ ? parallel_facet(at, from_front) : pinhole_facet(at, from_front);
  const std::uint8_t flags = scene.triangle_flags[t];
  if (!facet || ((flags & single_sided) != 0 && !from_front)) return {};

  facet->id = static_cast<PrimitiveId>(t);
  facet->occludes = (flags & see_through) == 0;
  facet->polygon = window_;
  for (const Line& line : facet->inside) {
    facet->polygon = facet->polygon.clipped(line, +1);
    if (facet->polygon.empty()) return {};
  }
  facet->nearness_bounds = {HUGE_VAL, -HUGE_VAL};
  for (const Integer3& p : facet->polygon.corners()) {
    const Bounds here = quotient_bounds(dot(facet->nearness, p), facet->denominator * p.z);
    facet->nearness_bounds.lo = std::min(facet->nearness_bounds.lo, here.lo);
    facet->nearness_bounds.hi = std::max(facet->nearness_bounds.hi, here.hi);
  }
  return facet;
}

// A ray with direction d = forward + x right + y up hits the triangle iff d is a combination of a, b, c with
// coefficients >= 0, that is iff (a x b).d, (b x c).d and (c x a).d have the sign of det(a, b, c). It does so
// at the distance n.a / n.d, where n is the triangle's normal and n.a = det(a, b, c).
std::optional<Facet> FrameView::pinhole_facet(const Corners& at, bool& from_front) const {
  const auto& [a, b, c] = at;
  const Integer3 n = cross(b - a, c - a);
  const Integer det = dot(n, a);
  if (det == 0) return {};
  from_front = det < 0;  // the eye, seen from a, lies on the normal's side

  const Integer sign = sgn(det);
  const auto along = [&](const Integer3& m) { return sign * on_window(m, dot(m, forward_)); };
  Facet facet;
  for (const Integer3& m : {cross(a, b), cross(b, c), cross(c, a)})
    facet.inside.push_back(make_line(along(m)));
  facet.nearness = along(n);
  facet.denominator = sign * det;
  return facet;
}

// A ray from p = x right + y up along f hits the triangle's line iff det(a - p, b - p, f) = (a x b).f +
// p.((a - b) x f) and its two sisters have the sign of n.f. It does so at the distance (n.a - n.p) / n.f,
// which has to be positive.
std::optional<Facet> FrameView::parallel_facet(const Corners& at, bool& from_front) const {
  const auto& [a, b, c] = at;
  const Integer3 n = cross(b - a, c - a);
  const Integer slope = dot(n, forward_);
  if (slope == 0) return {};
  from_front = slope < 0;

  const Integer sign = sgn(slope);
  const auto edge = [&](const Integer3& p, const Integer3& q) {
    return make_line(sign * on_window(cross(p - q, forward_), dot(cross(p, q), forward_)));
  };
  Facet facet;
  facet.nearness = sign * on_window(n, -dot(n, a));
  facet.denominator = sign * slope;
  facet.inside = {edge(a, b), edge(b, c), edge(c, a), make_line(-facet.nearness)};
  return facet;
}

Witness FrameView::ray_through(const Integer3& point, PrimitiveId id) const {
  const auto as_dyadic = [&](const Integer3& v, mp_bitcnt_t bits) {
    const long exponent = -static_cast<long>(bits) - scale_.exponent();
    return Vec3<Dyadic>{{v.x.get_str(), exponent}, {v.y.get_str(), exponent}, {v.z.get_str(), exponent}};
  };
  const mp_bitcnt_t bits = mpz_scan1(point.z.get_mpz_t(), 0);
  const Integer3 across = point.x * right_ + point.y * up_;
  if (parallel_) return {id, as_dyadic(point.z * eye_ + across, bits), as_dyadic(forward_, 0)};
  return {id, as_dyadic(eye_, 0), as_dyadic(point.z * forward_ + across, bits)};
}

Integer3 FrameView::on_window(const Integer3& m, const Integer& constant) const {
  return {dot(m, right_), dot(m, up_), constant};
}

}  // namespace provis::test
