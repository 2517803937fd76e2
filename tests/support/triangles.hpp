#pragma once
// Scenes made by hand, triangle by triangle.

#include "provis/scene.hpp"

namespace provis::test {

/// With vertices of its own.
inline void add_triangle(SceneArrays& scene, const Vec3d& a, const Vec3d& b, const Vec3d& c,
                         std::uint8_t flags = 0) {
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), {a, b, c});
  scene.triangles.push_back({first, first + 1, first + 2});
  scene.triangle_flags.push_back(flags);
}

}  // namespace provis::test
