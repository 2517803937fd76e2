#pragma once
// Exact numbers as they stand in results.

#include "predicates/exact_number.hpp"
#include "predicates/rational.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// Requires:   the denominator is a power of two
Dyadic dyadic(const Rational& x);
inline Dyadic dyadic(const ExactNumber& x) { return dyadic(static_cast<Rational>(x)); }

template <class N>
Vec3<Dyadic> dyadic(const Vec3<N>& v) {
  return {dyadic(v.x), dyadic(v.y), dyadic(v.z)};
}

}  // namespace provis
