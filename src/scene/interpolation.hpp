#pragma once
// The value of an animation's sampler at a time: the loading arithmetic of R1.

#include <cstddef>
#include <vector>

namespace provis {

enum class Interpolation { step, linear, cubic_spline };

/// What a sampler interpolates: a rotation's quaternions turn, other numbers move on lines.
enum class Quantity { plain, rotation };

struct KeyFrames {
  Interpolation interpolation = Interpolation::linear;
  Quantity quantity = Quantity::plain;
  std::size_t components = 0;  ///< of one value
  std::vector<double> times;   ///< seconds, strictly increasing
  std::vector<double> values;  ///< per key one value; for splines in-tangent, value and out-tangent
};

/// Before the first key it is the first key's value, after the last the last's, at a key that key's.
///
/// Returns:    components numbers, which may not be finite if the input is large
/// Requires:   at least one key; as many values as the times ask for
std::vector<double> value_at(const KeyFrames& keys, double time);

}  // namespace provis
