#pragma once
// The scene of reference_hash.py: signed zeros, subnormal and huge numbers, every flag, spheres.

#include "provis/scene.hpp"

namespace provis {

inline SceneArrays fixed_arrays() {
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, -0.0, 0}, {0.1, 1e300, -2.5}, {5e-324, -1e-310, 3}};
  arrays.triangles = {{0, 1, 2}, {1, 3, 2}, {3, 3, 0}};
  arrays.triangle_flags = {0, single_sided, single_sided | see_through};
  arrays.spheres = {{{1.5, -0.0, 0.3}, 0.25}, {{-7, 2, 1}, 0}};
  arrays.sphere_flags = {single_sided, see_through};
  return arrays;
}

}  // namespace provis
