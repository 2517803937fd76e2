#include "predicates/on_triangle.hpp"

#include <algorithm>

#include "predicates/exact_number.hpp"
#include "predicates/formulas.hpp"

namespace provis {
namespace {

bool between(double p, double a, double b, double c) {
  return std::min({a, b, c}) <= p && p <= std::max({a, b, c});
}

}  // namespace

bool on_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  // Comparisons of input numbers round nothing, and they settle nearly every case.
  if (!between(p.x, a.x, b.x, c.x) || !between(p.y, a.y, b.y, c.y) || !between(p.z, a.z, b.z, c.z))
    return false;
  using N = ExactNumber;
  const Vec3<N> o = numbers<N>(p), u = numbers<N>(a) - o, v = numbers<N>(b) - o, w = numbers<N>(c) - o;
  if (sign_of(dot(u, cross(v, w))) != Sign::zero) return false;
  // Inside means that the three areas seen from p do not turn against the triangle's own normal.
  const Vec3<N> n = cross(v - u, w - u);
  if (sign_of(dot(n, n)) == Sign::zero) return false;
  const auto along = [&](const Vec3<N>& s, const Vec3<N>& t) {
    return sign_of(dot(n, cross(s, t))) != Sign::negative;
  };
  return along(u, v) && along(v, w) && along(w, u);
}

}  // namespace provis
