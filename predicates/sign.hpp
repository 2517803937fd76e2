#pragma once
// The sign of a number: what every branch that matters is taken on.

namespace provis {

enum class Sign : signed char { negative = -1, zero = 0, positive = 1 };

constexpr Sign operator-(Sign s) { return static_cast<Sign>(-static_cast<int>(s)); }

constexpr Sign operator*(Sign a, Sign b) {
  return static_cast<Sign>(static_cast<int>(a) * static_cast<int>(b));
}

/// The sign of a float64 number that is known to be the exact value.
constexpr Sign sign_of(double exact) {
  return exact > 0 ? Sign::positive : exact < 0 ? Sign::negative : Sign::zero;
}

}  // namespace provis
