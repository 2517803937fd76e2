#pragma once
// Random views, points and window coordinates that sit on, or one ulp beside, every degeneracy there is.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "predicates/view_geometry.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

enum class NearFamily {
  generic,       ///< independent, uniform: nothing degenerate
  grid,          ///< small integers: many exact zeros
  coincident,    ///< few distinct positions; the eye may be one of them
  same_ray,      ///< points behind each other as seen from the eye, rounded
  coplanar,      ///< points of one plane, rounded
  collinear,     ///< points of one line, rounded
  proportional,  ///< eye-relative vectors that are multiples of each other, and frame vectors nearly so
  nudged,        ///< a grid with coordinates moved by one ulp
  far_away,      ///< a small scene with a large offset
  scaled,        ///< any of the above times a power of two, 1e-300 to 1e300
  mixed,         ///< every coordinate with an exponent of its own, moderate
  subnormal,     ///< points made of subnormal numbers
  extreme,       ///< every coordinate with an exponent of its own, any
};

inline constexpr NearFamily families[] = {
    NearFamily::generic,  NearFamily::grid,      NearFamily::coincident,   NearFamily::same_ray,
    NearFamily::coplanar, NearFamily::collinear, NearFamily::proportional, NearFamily::nudged,
    NearFamily::far_away, NearFamily::scaled,    NearFamily::mixed,        NearFamily::subnormal,
    NearFamily::extreme};

std::string_view name(NearFamily family);

/// What a test case starts from.
struct Input {
  ViewGeometry geometry;
  std::array<Vec3d, 7> points;
  std::array<double, 2> at;  ///< window coordinates
  Vec3d given;               ///< a ray without a definition; never zero
};

/// The input with this seed: the same on every machine, in every rounding mode.
Input make_input(NearFamily family, std::uint64_t seed);

/// Moves to a neighbouring float64 number, or not at all.
double nudged(double x, Random& random);

/// A finite number of any kind: subnormal, huge, small integers, powers of two and their neighbours.
double any_number(Random& random);

}  // namespace provis::test
