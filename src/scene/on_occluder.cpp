#include "src/scene/on_occluder.hpp"

#include "predicates/on_triangle.hpp"

namespace provis {

bool on_occluder(const Scene& scene, const Vec3d& p) {
  for (std::size_t t = 0; t < scene.triangles().size(); ++t)
    if (!(scene.triangle_flags()[t] & see_through) &&
        on_triangle(p, scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)))
      return true;
  return false;
}

}  // namespace provis
