#pragma once
// The filter's number: a float64 value with a radius that holds the true value, whatever the rounding mode.

#include <cmath>

#include "provis/vec3.hpp"

namespace provis {

/// Bound on the relative error of one float64 operation in any of the four rounding modes (2^-52).
inline constexpr double unit_roundoff = 0x1p-52;

/// Added wherever a product may underflow. It dwarfs all that is lost to that, even times any size in range;
/// a polynomial whose value is near it is simply not decided by the filter (ERRORS.md, 2).
inline constexpr double underflow_bound = 0x1p-600;

/// Nothing is claimed beyond it: where a result is too large, three of the four rounding modes may give the
/// largest finite number instead of infinity, and a radius cannot tell (ERRORS.md, 2).
inline constexpr double overflow_bound = 0x1p1000;

/// Factor that makes up for the rounding of the radius itself: at most eight operations (ERRORS.md, 3).
inline constexpr double radius_slack = 1 + 0x1p-48;

/// |true - value| <= radius. An infinite radius means that nothing is known; no radius is NaN.
struct Ball {
  double value = 0, radius = 0;

  Ball() = default;
  Ball(double exact) : value(exact) {}  // NOLINT: a float64 number is a ball of radius zero
  /// A NaN, in either, fails the comparison.
  Ball(double v, double r) : value(v), radius(std::fabs(v) + r < overflow_bound ? r : HUGE_VAL) {}
};

inline Ball operator-(const Ball& a) { return {-a.value, a.radius}; }

inline Ball operator+(const Ball& a, const Ball& b) {
  const double v = a.value + b.value;
  return {v, (a.radius + b.radius + unit_roundoff * std::fabs(v)) * radius_slack};
}

inline Ball operator-(const Ball& a, const Ball& b) {
  const double v = a.value - b.value;
  return {v, (a.radius + b.radius + unit_roundoff * std::fabs(v)) * radius_slack};
}

inline Ball operator*(const Ball& a, const Ball& b) {
  const double v = a.value * b.value;
  const double r = std::fabs(a.value) * b.radius + (std::fabs(b.value) + b.radius) * a.radius;
  return {v, (r + unit_roundoff * std::fabs(v)) * radius_slack + underflow_bound};
}

}  // namespace provis
