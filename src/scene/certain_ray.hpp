#pragma once
// A ray, and how it meets triangles, with certainty: intervals first, exact numbers where those cannot tell.
// A RoundUp guard must be alive.

#include <optional>

#include "predicates/ray_hit.hpp"
#include "src/scene/ray_box.hpp"

namespace provis {

/// N: exact numbers, rational or dyadic.
template <class N>
struct CertainRay {
  Vec3<N> origin, direction;
  Vec3<Interval> origin_bounds, direction_bounds;

  bool may_meet(const Box& box) const { return ray_may_meet(origin_bounds, direction_bounds, box); }
};

/// The signs of a RayHit. The exact one is made once, when it is needed.
template <class N>
class RaySigns {
 public:
  RaySigns(const CertainRay<N>& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c)
      : ray_(ray), a_(a), b_(b), c_(c), bounds_(ray_hit(ray.origin_bounds, ray.direction_bounds, a, b, c)) {}

  /// Whether the line of the ray certainly passes the triangle by. False where that is not quick to tell.
  bool certainly_beside() const {
    bool left = false, right = false;
    for (const Interval& pass : bounds_.passes) {
      left = left || pass.inf() > 0;
      right = right || pass.sup() < 0;
    }
    return left && right;
  }

  Sign along() { return sign(bounds_.along, &RayHit<N>::along); }
  Sign reach() { return sign(bounds_.reach, &RayHit<N>::reach); }
  Sign pass(int k) {
    if (const auto s = sign_of(bounds_.passes[k])) return *s;
    return sign_of(exact().passes[k]);
  }

 private:
  Sign sign(const Interval& bounds, N RayHit<N>::*part) {
    if (const auto s = sign_of(bounds)) return *s;
    return sign_of(exact().*part);
  }
  const RayHit<N>& exact() {
    if (!exact_) exact_ = ray_hit(ray_.origin, ray_.direction, a_, b_, c_);
    return *exact_;
  }

  const CertainRay<N>& ray_;
  const Vec3d &a_, &b_, &c_;
  RayHit<Interval> bounds_;
  std::optional<RayHit<N>> exact_;
};

}  // namespace provis
