#include "predicates/zero_area.hpp"

#include <cmath>

#include "predicates/ball.hpp"
#include "predicates/exact_number.hpp"

namespace provis {
namespace {

/// Twice the area, as a vector.
template <class Number>
Vec3<Number> normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto as_numbers = [](const Vec3d& p) { return Vec3<Number>{Number(p.x), Number(p.y), Number(p.z)}; };
  const Vec3<Number> o = as_numbers(a);
  return cross(as_numbers(b) - o, as_numbers(c) - o);
}

bool is_certainly_not_zero(const Ball& ball) { return std::fabs(ball.value) > ball.radius; }

}  // namespace

bool zero_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if (a == b || b == c || c == a) return true;
  const Vec3<Ball> near = normal<Ball>(a, b, c);
  if (is_certainly_not_zero(near.x) || is_certainly_not_zero(near.y) || is_certainly_not_zero(near.z))
    return false;
  const Vec3<ExactNumber> n = normal<ExactNumber>(a, b, c);
  return sign_of(n.x) == Sign::zero && sign_of(n.y) == Sign::zero && sign_of(n.z) == Sign::zero;
}

}  // namespace provis
