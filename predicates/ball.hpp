#pragma once
// The filter's number: a float64 value with a radius that holds the true value, whatever the rounding mode.

#include <cmath>

#include "provis/vec3.hpp"

namespace provis {

/// Bound on the relative error of one float64 operation in any of the four rounding modes (2^-52).
inline constexpr double unit_roundoff = 0x1p-52;

/// Added wherever a product may underflow. It dwarfs every subnormal, so no later product of it falls
/// among them; a polynomial whose value is near it is simply not decided by the filter (ERRORS.md, 2).
inline constexpr double underflow_bound = 0x1p-600;

/// Factor that makes up for the rounding of the radius itself: at most eight operations (ERRORS.md, 3).
inline constexpr double radius_slack = 1 + 0x1p-48;

/// |true - value| <= radius. A radius that is infinite or NaN means that nothing is known.
struct Ball {
  double value = 0, radius = 0;

  Ball() = default;
  Ball(double exact) : value(exact) {}  // NOLINT: a float64 number is a ball of radius zero
  Ball(double v, double r) : value(v), radius(r) {}
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
