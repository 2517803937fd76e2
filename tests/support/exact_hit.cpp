#include "tests/support/exact_hit.hpp"

#include <algorithm>

namespace provis::test {

bool Surface::is_coplanar_with(const Surface& other) const {
  return std::all_of(other.corner.begin(), other.corner.end(),
                     [&](const Integer3& p) { return dot(normal, p - corner[0]) == 0; });
}

std::vector<Surface> surfaces_of(const SceneArrays& scene, const CommonScale& scale) {
  std::vector<Surface> surfaces;
  for (PrimitiveId t = 0; t < scene.triangles.size(); ++t) {
    Surface s;
    s.id = t;
    for (std::size_t k = 0; k < 3; ++k) s.corner[k] = scale(scene.vertices[scene.triangles[t][k]]);
    s.normal = cross(s.corner[1] - s.corner[0], s.corner[2] - s.corner[0]);
    s.single_sided = (scene.triangle_flags[t] & single_sided) != 0;
    s.occludes = (scene.triangle_flags[t] & see_through) == 0;
    if (s.normal != Integer3{}) surfaces.push_back(std::move(s));
  }
  return surfaces;
}

HitNumbers numbers(const Surface& surface, const ExactRay& ray) {
  HitNumbers n;
  n.across = dot(surface.normal, ray.direction);
  n.away = dot(surface.normal, ray.weight * surface.corner[0] - ray.origin);
  // The point in which the ray's line meets the plane is (origin + away/across direction) / weight.
  const Integer3 point = n.across * ray.origin + n.away * ray.direction;
  const Integer scale = n.across * ray.weight;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer3 &a = surface.corner[k], &b = surface.corner[(k + 1) % 3];
    n.edge[k] = sgn(n.across) * dot(surface.normal, cross(b - a, point - scale * a));
  }
  return n;
}

std::optional<ExactHit> hit(const Surface& surface, const ExactRay& ray) {
  const HitNumbers n = numbers(surface, ray);
  if (n.away == 0 || sgn(n.away) != sgn(n.across)) return {};
  const bool from_behind = n.away > 0;  // the corner is farther along the normal than the origin
  if (from_behind && surface.single_sided) return {};
  const Integer& least = *std::min_element(n.edge.begin(), n.edge.end());
  if (least < 0) return {};
  Rational distance(n.away, n.across * ray.weight);
  distance.canonicalize();
  return ExactHit{&surface, std::move(distance), least > 0};
}

bool starts_on(const Surface& surface, const ExactRay& ray) {
  if (dot(surface.normal, ray.weight * surface.corner[0] - ray.origin) != 0) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer3 &a = surface.corner[k], &b = surface.corner[(k + 1) % 3];
    if (dot(surface.normal, cross(b - a, ray.origin - ray.weight * a)) < 0) return false;
  }
  return true;
}

}  // namespace provis::test
