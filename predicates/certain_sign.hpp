#pragma once
// The sign of a polynomial by intervals where they tell, by exact numbers where they do not.

#include "predicates/decide.hpp"

namespace provis {

/// formula: a template over the number type, without arguments. A RoundUp guard must be alive.
template <class Formula>
Sign certain_sign(const Formula& formula) {
  return decide<Arithmetic::chain>([&]<class N>() { return sign_of(formula.template operator()<N>()); }).sign;
}

}  // namespace provis
