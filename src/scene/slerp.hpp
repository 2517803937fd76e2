#pragma once
// The factors of spherical linear interpolation, rounded once.

namespace provis {

struct SlerpFactors {
  double from = 0, to = 0;
};

/// sin((1 - u) a) / sin(a) and sin(u a) / sin(a), where a = arccos(cosine).
///
/// Guarantee:  each is the float64 number nearest to the real one: the same on every machine
/// Requires:   0 <= cosine < 1, 0 <= u <= 1
/// Throws:     Error::internal where they are not
/// Source:     K. Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985
SlerpFactors slerp_factors(double cosine, double u);

}  // namespace provis
