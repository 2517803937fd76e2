#include "predicates/zero_area.hpp"

#include "predicates/exact_number.hpp"

namespace provis {
namespace {

using Exact = Vec3<ExactNumber>;

Exact exact(const Vec3d& p) { return {ExactNumber(p.x), ExactNumber(p.y), ExactNumber(p.z)}; }

}  // namespace

bool zero_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if (a == b || b == c || c == a) return true;
  const Exact o = exact(a);
  const Exact n = cross(exact(b) - o, exact(c) - o);
  return sign_of(n.x) == Sign::zero && sign_of(n.y) == Sign::zero && sign_of(n.z) == Sign::zero;
}

}  // namespace provis
