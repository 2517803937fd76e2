#pragma once
// The interval tier's number: CGAL's unprotected interval; a RoundUp guard must be alive.

#include <CGAL/Interval_nt.h>

#include <optional>

#include "predicates/sign.hpp"

namespace provis {

using Interval = CGAL::Interval_nt<false>;

/// Zero only where the interval is the point 0: then nothing was rounded, or rounding did not matter.
inline std::optional<Sign> sign_of(const Interval& i) {
  if (i.inf() > 0) return Sign::positive;
  if (i.sup() < 0) return Sign::negative;
  if (i.inf() == 0 && i.sup() == 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace provis
