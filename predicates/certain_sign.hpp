#pragma once
// The sign of a polynomial by intervals where they tell, by exact numbers where they do not.

#include "predicates/decide.hpp"

namespace provis {

/// How many signs a thread has decided so far, by tier.
struct CertainSigns {
  std::uint64_t interval = 0, exact = 0;
};
inline thread_local CertainSigns certain_signs;

/// formula: a template over the number type, without arguments. A RoundUp guard must be alive.
template <class Formula>
Sign certain_sign(const Formula& formula) {
  const Decision d =
      decide<Arithmetic::chain>([&]<class N>() { return sign_of(formula.template operator()<N>()); });
  ++(d.tier == Tier::exact ? certain_signs.exact : certain_signs.interval);
  return d.sign;
}

}  // namespace provis
