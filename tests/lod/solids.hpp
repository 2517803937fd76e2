#pragma once
// Closed surfaces out of triangles, fronts outside.

#include <array>
#include <vector>

#include "provis/scene.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

using Corners = std::array<Vec3d, 3>;
using Soup = std::vector<Corners>;

struct SolidBox {
  Vec3d lower, upper;
};

/// Each face cut into a grid of its own, drawn by `random` from 1 to most squared: where neighbours differ,
/// vertices lie inside edges.
Soup box_solid(const SolidBox& box, int most, Random& random);
Soup box_solid(const SolidBox& box);
Soup octahedron(const Vec3d& center, double radius);
/// An octahedron whose triangles were cut in four so many times, rounded to a sphere.
Soup ball(const Vec3d& center, double radius, int cuts);

SolidBox around(const Soup& soup);
Soup scaled(Soup soup, const Vec3d& center, double factor);
Soup reversed(Soup soup);
Soup joined(Soup a, const Soup& b);

/// Adds the triangles, each with vertices of its own. Returns the ids as a range.
struct AddedIds {
  PrimitiveId first = 0, count = 0;
};
AddedIds add(SceneArrays& scene, const Soup& soup, std::uint8_t flags);

}  // namespace provis::test
