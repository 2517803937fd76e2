#include "src/scene/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "src/scene/slerp.hpp"

namespace provis {
namespace {

using Values = std::span<const double>;

/// The parts of a spline's key, in the order of the file; other keys have a value only.
enum Part : std::size_t { in_tangent, value, out_tangent };

Values part(const KeyFrames& keys, std::size_t key, Part which) {
  const bool spline = keys.interpolation == Interpolation::cubic_spline;
  const std::size_t position = spline ? 3 * key + which : key;
  return Values(keys.values).subspan(position * keys.components, keys.components);
}

std::vector<double> key_value(const KeyFrames& keys, std::size_t key) {
  const Values v = part(keys, key, value);
  return {v.begin(), v.end()};
}

std::vector<double> weighted_sum(double k0, Values v0, double k1, Values v1, double sign = 1) {
  std::vector<double> sum(v0.size());
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = k0 * v0[i] + k1 * (sign * v1[i]);
  return sum;
}

/// The shorter way round; quaternions so close that c does not tell them from parallel move on a line.
std::vector<double> turned(Values q0, Values q1, double u) {
  const double c = ((q0[0] * q1[0] + q0[1] * q1[1]) + q0[2] * q1[2]) + q0[3] * q1[3];
  const double sign = c < 0 ? -1 : 1;
  if (!(std::abs(c) < 1)) return weighted_sum(1 - u, q0, u, q1, sign);
  const SlerpFactors k = slerp_factors(std::abs(c), u);
  return weighted_sum(k.from, q0, k.to, q1, sign);
}

std::vector<double> spline(const KeyFrames& keys, std::size_t key, double d, double u) {
  const Values v0 = part(keys, key, value), b0 = part(keys, key, out_tangent),
               v1 = part(keys, key + 1, value), a1 = part(keys, key + 1, in_tangent);
  const double u2 = u * u, u3 = u2 * u;
  const double c0 = (2 * u3 - 3 * u2) + 1, c1 = d * ((u3 - 2 * u2) + u), c2 = 3 * u2 - 2 * u3,
               c3 = d * (u3 - u2);
  std::vector<double> sum(keys.components);
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = ((c0 * v0[i] + c1 * b0[i]) + c2 * v1[i]) + c3 * a1[i];
  return sum;
}

void normalise(std::vector<double>& q) {
  const double length = std::sqrt(((q[0] * q[0] + q[1] * q[1]) + q[2] * q[2]) + q[3] * q[3]);
  for (double& x : q) x /= length;
}

}  // namespace

std::vector<double> value_at(const KeyFrames& keys, double time) {
  if (!(time < keys.times.back())) return key_value(keys, keys.times.size() - 1);
  if (time <= keys.times.front()) return key_value(keys, 0);
  const auto next = std::ranges::upper_bound(keys.times, time);
  const auto key = static_cast<std::size_t>(next - keys.times.begin()) - 1;
  const double t0 = keys.times[key], d = *next - t0, u = (time - t0) / d;
  if (time == t0 || keys.interpolation == Interpolation::step) return key_value(keys, key);
  const bool rotation = keys.quantity == Quantity::rotation;
  if (keys.interpolation == Interpolation::cubic_spline) {
    std::vector<double> sum = spline(keys, key, d, u);
    if (rotation) normalise(sum);
    return sum;
  }
  const Values v0 = part(keys, key, value), v1 = part(keys, key + 1, value);
  return rotation ? turned(v0, v1, u) : weighted_sum(1 - u, v0, u, v1);
}

}  // namespace provis
