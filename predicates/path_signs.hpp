#pragma once
// Certain signs of what happens at a pixel's centre while the camera translates: the tiers behind the filter,
// which engines keep beside their float64 numbers.

#include "predicates/path.hpp"
#include "predicates/sign.hpp"
#include "provis/arithmetic.hpp"

namespace provis {

/// Signs under one arithmetic policy, for one frame, counted. One object per task; a RoundUp guard must be
/// alive on the thread (for Arithmetic::doubles a RoundNearest guard).
///
/// Guarantee:  exact for every policy but Arithmetic::doubles, which takes the sign of the rounded value
///             and, where the geometry says `checked`, counts how often that is not the exact one
template <Arithmetic A>
class PathSigns {
 public:
  PathSigns(const PathGeometry& geometry, SignCounts& counts) : geometry_(geometry), counts_(counts) {}

  const PathGeometry& geometry() const { return geometry_; }

  /// Negative if a ray that meets the triangle meets its front, zero if it cannot.
  Sign along(const Pixel& at, const Corners& triangle);

  Sign at_zero(const Pixel& at, const Motion& motion);
  Sign slope(const Pixel& at, const Motion& motion);

  /// The sign of event_order.
  Sign order(const Pixel& at, const Motion& first, const Motion& second);

  /// Whether p lies in the triangle's plane: zero if so.
  Sign height(const Vec3d& p, const Corners& triangle);

  void count(Predicate p, Tier t) { ++counts_.at(p, t); }
  void count_wrong(Predicate p) { ++counts_.wrong_of(p); }

 private:
  template <class Formula>
  Sign decided(Predicate p, const Formula& formula);

  const PathGeometry& geometry_;
  SignCounts& counts_;
};

extern template class PathSigns<Arithmetic::doubles>;
extern template class PathSigns<Arithmetic::chain>;
extern template class PathSigns<Arithmetic::mpfr>;
extern template class PathSigns<Arithmetic::exact>;

}  // namespace provis
