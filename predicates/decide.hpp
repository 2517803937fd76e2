#pragma once
// The tiers behind the filter, one after another, for any formula.

#include "predicates/ball.hpp"
#include "predicates/environment.hpp"
#include "predicates/exact_number.hpp"
#include "predicates/interval.hpp"
#include "predicates/mpfi_number.hpp"
#include "provis/arithmetic.hpp"
#include "provis/error.hpp"

namespace provis {

// 53 bits more at a time settle what is merely close; a wide spread of exponents can need thousands, and is
// reached by doubling.
inline constexpr long first_mpfr_bits = 212, more_mpfr_bits = 53,
                      fine_steps_end = first_mpfr_bits + 16 * more_mpfr_bits;

inline std::optional<Sign> sign_of(const Ball& b) {
  if (b.value > b.radius) return Sign::positive;
  if (b.value < -b.radius) return Sign::negative;
  return std::nullopt;
}

struct Decision {
  Sign sign;
  Tier tier;
};

/// Evaluates `formula`, a generic callable over the number type, tier after tier.
template <Arithmetic A, class Formula>
Decision decide(const Formula& formula) {
  if constexpr (A == Arithmetic::doubles) return {formula.template operator()<double>(), Tier::filter};
  if constexpr (A == Arithmetic::chain) {
    if (!rounds_up()) throw Error(Error::Code::internal, "interval tier", "no RoundUp guard on this thread");
    if (const std::optional<Sign> s = formula.template operator()<Interval>()) return {*s, Tier::interval};
    // No MPFR here: what intervals leave open is nearly always zero, and exact numbers say so ten times
    // faster.
  }
  if constexpr (A == Arithmetic::mpfr) {
    for (long bits = first_mpfr_bits;; bits += bits < fine_steps_end ? more_mpfr_bits : bits) {
      const MpfiPrecision precision(bits);
      if (const std::optional<Sign> s = formula.template operator()<MpfiNumber>()) return {*s, Tier::mpfr};
    }
  }
  return {formula.template operator()<ExactNumber>(), Tier::exact};
}

/// Whether plain doubles were mistaken. `taken` is an argument so that it is known before the rounding mode
/// changes; nothing else of the caller's arithmetic may move in here.
template <class Formula>
[[gnu::noinline]] bool mistaken(Sign taken, const Formula& formula) {
  const RoundUp guard;
  return decide<Arithmetic::chain>(formula).sign != taken;
}

}  // namespace provis
