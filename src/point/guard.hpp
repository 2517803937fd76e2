#pragma once
// The rounding mode an arithmetic policy works in.

#include <type_traits>

#include "predicates/environment.hpp"
#include "provis/arithmetic.hpp"

namespace provis {

template <Arithmetic A>
using RoundingGuard = std::conditional_t<A == Arithmetic::doubles, RoundNearest, RoundUp>;

}  // namespace provis
