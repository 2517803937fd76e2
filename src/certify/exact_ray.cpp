#include "src/certify/exact_ray.hpp"

#include <gmp.h>
#include <mpfr.h>

#include <algorithm>
#include <cmath>

#include "predicates/formulas.hpp"
#include "predicates/ray_hit.hpp"
#include "provis/error.hpp"
#include "src/scene/ray_box.hpp"

namespace provis {
namespace {

using N = ExactNumber;

/// 2^exponent, one float64 factor at a time.
N scaled_by_power(N x, long exponent) {
  constexpr long step = 1000;
  for (; exponent != 0;) {
    const long now = std::clamp(exponent, -step, step);
    x = x * N(std::ldexp(1.0, static_cast<int>(now)));
    exponent -= now;
  }
  return x;
}

N read(const Dyadic& d) {
  constexpr long most_bits = 1L << 24;
  CGAL::Gmpz m;
  if (mpz_set_str(m.mpz(), d.mantissa.c_str(), 10) != 0 || std::labs(d.exponent) > most_bits)
    throw Error(Error::Code::rejected, "witness", "not a number: " + d.mantissa);
  if (m == 0) return N(0.0);
  const N magnitude(CGAL::abs(m));  // the constructor forgets the sign
  return scaled_by_power(m < 0 ? -magnitude : magnitude, d.exponent);
}

Vec3<N> read(const Vec3<Dyadic>& v) { return {read(v.x), read(v.y), read(v.z)}; }

/// Mpzf's own conversion to an interval is wrong among the subnormals while rounding upwards (CGAL 5.5.1).
Interval bounds(const N& x) {
  const CGAL::Gmpq q = static_cast<CGAL::Gmpq>(x);
  mpfr_t exact;
  mpfr_init2(exact, std::max<mpfr_prec_t>(MPFR_PREC_MIN,
                                          static_cast<mpfr_prec_t>(mpz_sizeinbase(q.numerator().mpz(), 2))));
  // The denominator is a power of two, and the precision holds the whole numerator: nothing is rounded yet.
  mpfr_set_q(exact, q.mpq(), MPFR_RNDN);
  const Interval result(mpfr_get_d(exact, MPFR_RNDD), mpfr_get_d(exact, MPFR_RNDU));
  mpfr_clear(exact);
  return result;
}

Vec3<Interval> bounds(const Vec3<N>& v) { return {bounds(v.x), bounds(v.y), bounds(v.z)}; }

template <class T>
RayHit<T> ray_hit(const Vec3<T>& origin, const Vec3<T>& direction, const Scene& scene, std::size_t t) {
  return provis::ray_hit(origin, direction, scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2));
}

/// The interval's sign where it has one, the exact number's otherwise.
template <class Exact>
Sign certain(const Interval& i, const Exact& exact) {
  const auto s = sign_of(i);
  return s ? *s : sign_of(exact());
}

}  // namespace

ExactRay::ExactRay(const Witness& witness)
    : origin_(read(witness.origin)),
      direction_(read(witness.direction)),
      origin_bounds_(bounds(origin_)),
      direction_bounds_(bounds(direction_)) {
  if (sign_of(dot(direction_, direction_)) == Sign::zero)
    throw Error(Error::Code::rejected, "witness", "the direction is zero");
}

Passage ExactRay::passage(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
  const RayHit<Interval> i = provis::ray_hit(origin_bounds_, direction_bounds_, a, b, c);
  const auto exact = [&] { return provis::ray_hit(origin_, direction_, a, b, c); };
  Passage p;
  for (int k = 0; k < 3; ++k) p.passes[k] = certain(i.passes[k], [&] { return exact().passes[k]; });
  p.along = certain(i.along, [&] { return exact().along; });
  p.reach = certain(i.reach, [&] { return exact().reach; });
  return p;
}

bool ExactRay::starts_on(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
  const auto height = [&](const auto& origin) {
    return [&, o = origin]<class T>(T) {
      const Vec3<T> p = numbers<T>(a);
      return dot(cross(numbers<T>(b) - p, numbers<T>(c) - p), o - p);
    };
  };
  const auto exact = [&] { return height(origin_)(N()); };
  if (certain(height(origin_bounds_)(Interval()), exact) != Sign::zero) return false;
  // Inside means that the three areas seen from the origin do not turn against the triangle's own normal.
  const Vec3<N> u = numbers<N>(a) - origin_, v = numbers<N>(b) - origin_, w = numbers<N>(c) - origin_;
  const Vec3<N> n = cross(v - u, w - u);
  const auto along = [&](const Vec3<N>& s, const Vec3<N>& t) {
    return sign_of(dot(n, cross(s, t))) != Sign::negative;
  };
  return sign_of(dot(n, n)) != Sign::zero && along(u, v) && along(v, w) && along(w, u);
}

Sign ExactRay::compare(const Scene& scene, std::size_t first, std::size_t second) const {
  // reach2/along2 - reach1/along1, over the product of both denominators and its sign.
  const auto difference = [&](const auto& origin, const auto& direction) {
    const auto f = ray_hit(origin, direction, scene, first), s = ray_hit(origin, direction, scene, second);
    return (s.reach * f.along - f.reach * s.along) * (f.along * s.along);
  };
  return certain(difference(origin_bounds_, direction_bounds_),
                 [&] { return difference(origin_, direction_); });
}

bool ExactRay::may_meet(const Box& box) const { return ray_may_meet(origin_bounds_, direction_bounds_, box); }

bool passes_window(const ViewGeometry& g, const Window& w, const Vec3<ExactNumber>& ray) {
  const auto side = [&](const Vec3<N>& line) { return sign_of(dot(line, ray)) * g.handedness; };
  return side(image_side<N>(g)) == Sign::positive && side(x_border<N>(g, w.x0)) != Sign::negative &&
         side(x_border<N>(g, w.x1)) != Sign::positive && side(y_border<N>(g, w.y0)) != Sign::negative &&
         side(y_border<N>(g, w.y1)) != Sign::positive;
}

bool coplanar(const Scene& scene, std::size_t first, std::size_t second) {
  const Vec3d &a = scene.corner(first, 0), &b = scene.corner(first, 1), &c = scene.corner(first, 2);
  const auto height = [&]<class T>(const Vec3d& p) {
    const Vec3<T> o = numbers<T>(a);
    return dot(cross(numbers<T>(b) - o, numbers<T>(c) - o), numbers<T>(p) - o);
  };
  for (int k = 0; k < 3; ++k) {
    const Vec3d& p = scene.corner(second, k);
    if (certain(height.template operator()<Interval>(p), [&] { return height.template operator()<N>(p); }) !=
        Sign::zero)
      return false;
  }
  return true;
}

}  // namespace provis
