#include "src/region/dyadic_point.hpp"

#include <algorithm>
#include <utility>

#include "predicates/rational.hpp"

namespace provis {
namespace {

using Point = Vec3<Rational>;

Rational value(const Dyadic& d) {
  CGAL::Gmpz m, power;
  mpz_set_str(m.mpz(), d.mantissa.c_str(), 10);
  mpz_ui_pow_ui(power.mpz(), 2, static_cast<unsigned long>(std::labs(d.exponent)));
  return d.exponent < 0 ? Rational(m, power) : Rational(m * power);
}

Point exact(const Vec3d& p) { return {Rational(p.x), Rational(p.y), Rational(p.z)}; }

bool between(const Rational& p, double a, double b, double c) {
  return p >= Rational(std::min({a, b, c})) && p <= Rational(std::max({a, b, c}));
}

/// Float64 numbers around an exact one.
using Bounds = std::pair<double, double>;

bool certainly_beyond(const Bounds& p, double a, double b, double c) {
  return p.second < std::min({a, b, c}) || p.first > std::max({a, b, c});
}

}  // namespace

struct DyadicPoint::Numbers {
  Point exact;
  Bounds x, y, z;
};

DyadicPoint::DyadicPoint(const Vec3<Dyadic>& p)
    : numbers_(std::make_unique<Numbers>(Numbers{{value(p.x), value(p.y), value(p.z)}, {}, {}, {}})) {
  const Point& e = numbers_->exact;
  numbers_->x = CGAL::to_interval(e.x);
  numbers_->y = CGAL::to_interval(e.y);
  numbers_->z = CGAL::to_interval(e.z);
}

DyadicPoint::~DyadicPoint() = default;

bool DyadicPoint::lies_on(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
  if (certainly_beyond(numbers_->x, a.x, b.x, c.x) || certainly_beyond(numbers_->y, a.y, b.y, c.y) ||
      certainly_beyond(numbers_->z, a.z, b.z, c.z))
    return false;
  const Point& p = numbers_->exact;
  if (!between(p.x, a.x, b.x, c.x) || !between(p.y, a.y, b.y, c.y) || !between(p.z, a.z, b.z, c.z))
    return false;
  const Point u = exact(a) - p, v = exact(b) - p, w = exact(c) - p, n = cross(v - u, w - u);
  if (dot(u, cross(v, w)) != 0 || dot(n, n) == 0) return false;
  return dot(n, cross(u, v)) >= 0 && dot(n, cross(v, w)) >= 0 && dot(n, cross(w, u)) >= 0;
}

bool on_occluder(const Scene& scene, const Vec3<Dyadic>& p) {
  const DyadicPoint point(p);
  for (std::size_t t = 0; t < scene.triangles().size(); ++t)
    if (!(scene.triangle_flags()[t] & see_through) &&
        point.lies_on(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)))
      return true;
  return false;
}

}  // namespace provis
