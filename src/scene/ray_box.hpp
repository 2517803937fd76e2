#pragma once
// A ray against a box, in intervals.

#include <algorithm>
#include <cmath>

#include "predicates/interval.hpp"
#include "src/scene/box_tree.hpp"

namespace provis {

/// False only if the ray certainly misses the box. A RoundUp guard must be alive.
inline bool ray_may_meet(const Vec3<Interval>& origin, const Vec3<Interval>& direction, const Box& box) {
  // Along each axis the ray is inside the slab for a range of distances; the ranges must have a common point.
  double from = 0, to = HUGE_VAL;
  const auto slab = [&](double lo, double hi, const Interval& o, const Interval& d) {
    if (d.inf() <= 0 && d.sup() >= 0)
      return !(d.inf() == 0 && d.sup() == 0) || (o.sup() >= lo && o.inf() <= hi);
    const Interval a = (Interval(lo) - o) / d, b = (Interval(hi) - o) / d;
    from = std::max(from, std::min(a.inf(), b.inf()));
    to = std::min(to, std::max(a.sup(), b.sup()));
    return !(from > to);
  };
  return slab(box.lower.x, box.upper.x, origin.x, direction.x) &&
         slab(box.lower.y, box.upper.y, origin.y, direction.y) &&
         slab(box.lower.z, box.upper.z, origin.z, direction.z);
}

}  // namespace provis
