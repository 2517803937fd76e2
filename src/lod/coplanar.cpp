#include "src/lod/coplanar.hpp"

#include <algorithm>

#include "predicates/certain_sign.hpp"
#include "predicates/formulas.hpp"

namespace provis::lod {

Coplanar::Coplanar(const Corners& t) {
  for (int axis = 0; axis < 3; ++axis) {
    i_ = (axis + 1) % 3;
    j_ = (axis + 2) % 3;
    if (turn(t[0], t[1], t[2]) != Sign::zero) return;
  }
}

Sign Coplanar::turn(const Vec3d& a, const Vec3d& b, const Vec3d& p) const {
  return certain_sign([&]<class N>() {
    const Vec3<N> o = numbers<N>(a), u = numbers<N>(b) - o, v = numbers<N>(p) - o;
    return component(u, i_) * component(v, j_) - component(u, j_) * component(v, i_);
  });
}

bool Coplanar::covers(const Corners& t, const Corners& p) const {
  const Sign inwards = turn(t[0], t[1], t[2]);
  return std::all_of(p.begin(), p.end(), [&](const Vec3d& q) {
    return turn(t[0], t[1], q) * inwards != Sign::negative &&
           turn(t[1], t[2], q) * inwards != Sign::negative && turn(t[2], t[0], q) * inwards != Sign::negative;
  });
}

bool Coplanar::beyond_an_edge(const Corners& t, const Corners& p) const {
  const Sign inwards = turn(t[0], t[1], t[2]);
  for (std::size_t k = 0; k < 3; ++k)
    if (std::all_of(p.begin(), p.end(), [&](const Vec3d& q) {
          return turn(t[k], t[(k + 1) % 3], q) * inwards != Sign::positive;
        }))
      return true;
  return false;
}

bool Coplanar::apart(const Corners& t, const Corners& p) const {
  return beyond_an_edge(t, p) || beyond_an_edge(p, t);
}

}  // namespace provis::lod
