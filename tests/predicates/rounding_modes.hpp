#pragma once
// The filter has to hold in all four rounding modes; the tests put it into each.

#include <cfenv>
#include <optional>

#include "predicates/ball.hpp"
#include "predicates/sign.hpp"

namespace provis::test {

inline constexpr int all_modes[] = {FE_UPWARD, FE_TONEAREST, FE_DOWNWARD, FE_TOWARDZERO};

class RoundingMode {
 public:
  explicit RoundingMode(int mode) : saved_(std::fegetround()) { std::fesetround(mode); }
  ~RoundingMode() { std::fesetround(saved_); }
  RoundingMode(const RoundingMode&) = delete;
  RoundingMode& operator=(const RoundingMode&) = delete;

 private:
  int saved_;
};

inline std::optional<Sign> certain_sign(double value, double bound) {
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return std::nullopt;
}

inline std::optional<Sign> certain_sign(const Ball& b) { return certain_sign(b.value, b.radius); }

}  // namespace provis::test
