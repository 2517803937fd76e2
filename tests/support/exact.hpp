#pragma once
// Exact numbers for the oracles: float64 input becomes integers by one common power of two.

#include <gmpxx.h>

#include <span>

#include "provis/scene.hpp"
#include "provis/vec3.hpp"
#include "provis/view.hpp"

namespace provis::test {

using Integer = mpz_class;
using Integer3 = Vec3<Integer>;

/// The smallest power of two that turns every float64 it was shown into an integer.
class CommonScale {
 public:
  void include(double value);
  void include(const Vec3d& v);

  Integer operator()(double value) const;
  Integer3 operator()(const Vec3d& v) const;

  int exponent() const { return exponent_; }

 private:
  int exponent_ = 0;  // numbers are multiplied by 2^exponent_, never less than 0
};

/// A scale for all vertices that triangles use, the eye and the frame vectors of a query.
CommonScale scale_of(const SceneArrays& scene, const PointView& view);

/// An interval of float64 that holds an exact value.
struct Bounds {
  double lo, hi;
};

/// Bounds on numerator / denominator, denominator > 0.
Bounds quotient_bounds(const Integer& numerator, const Integer& denominator);

/// Divides by the largest power of two that all three coordinates share; only a positive factor changes.
void drop_common_twos(Integer3& v);

/// A vector that remembers a float64 picture of itself, so that most signs need no long arithmetic.
/// The picture is the vector times a power of two that brings its largest coordinate into [1/2, 1),
/// each coordinate truncated: it is off by less than 2^-52.
class Shadowed {
 public:
  explicit Shadowed(Integer3 exact);

  const Integer3& exact() const { return exact_; }

  /// Exact sign of the scalar product. Each product of pictures is off by less than 3 * 2^-52 and their
  /// sum in float64 by less than 2^-49 altogether, so a sum beyond 2^-47 has the right sign.
  friend int sign_of_dot(const Shadowed& a, const Shadowed& b);

 private:
  Integer3 exact_;
  Vec3d picture_;
};

}  // namespace provis::test
