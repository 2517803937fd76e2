#pragma once
// Triangles in no order and no degenerate position, for what rounds.

#include "provis/scene.hpp"
#include "tests/support/random.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {

inline SceneArrays with(SceneArrays arrays, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                        std::uint8_t flags = 0) {
  add_triangle(arrays, a, b, c, flags);
  return arrays;
}

inline Vec3d point(Random& random, double size) {
  const auto x = [&] { return size * (2 * random.unit() - 1); };
  const double a = x(), b = x(), c = x();
  return {a, b, c};
}

/// Triangles of all sizes around the origin, of every kind, many of them reaching behind the camera.
inline SceneArrays soup(Random& random) {
  SceneArrays arrays;
  for (int k = 0; k < 150; ++k) {
    const Vec3d at = point(random, 6);
    const double size = random.pick({0.1, 0.5, 3.0});
    const auto flags = static_cast<std::uint8_t>((random.chance(30) ? single_sided : 0) |
                                                 (random.chance(20) ? see_through : 0));
    arrays =
        with(arrays, at + point(random, size), at + point(random, size), at + point(random, size), flags);
  }
  return arrays;
}

}  // namespace provis::test
