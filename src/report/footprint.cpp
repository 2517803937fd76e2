#include "src/report/footprint.hpp"

#include <cmath>

namespace provis {

namespace {

double length(const Vec3d& v) { return std::sqrt(dot(v, v)); }

double cosine_between(const Vec3d& a, const Vec3d& b) {
  const double lengths = length(a) * length(b);
  return lengths > 0 ? dot(a, b) / lengths : 1;
}

// The smallest positive distance at which the ray meets the sphere's surface.
std::optional<double> sphere_distance(const Sphere& sphere, const Vec3d& origin, const Vec3d& direction) {
  const Vec3d from_center = origin - sphere.center;
  const double a = dot(direction, direction), b = dot(from_center, direction);
  const double c = dot(from_center, from_center) - sphere.radius * sphere.radius;
  const double discriminant = b * b - a * c;
  if (!(discriminant >= 0) || a == 0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  const double first = (-b - root) / a, second = (-b + root) / a;
  if (first > 0) return first;
  if (second > 0) return second;
  return std::nullopt;
}

}  // namespace

std::optional<Footprint> Footprint::of(const Scene& scene, PrimitiveId id, const Raster& raster) {
  const std::size_t triangles = scene.triangles().size();
  Footprint footprint;
  footprint.id_ = id;
  const bool seen =
      id < triangles
          ? footprint.set_triangle({scene.corner(id, 0), scene.corner(id, 1), scene.corner(id, 2)}, raster)
          : footprint.set_sphere(scene.spheres()[id - triangles], raster);
  if (!seen || footprint.box_.empty()) return std::nullopt;
  return footprint;
}

bool Footprint::set_triangle(const std::array<Vec3d, 3>& corners, const Raster& raster) {
  const std::array<Vec3d, 3> p = {raster.to_frame(corners[0]), raster.to_frame(corners[1]),
                                  raster.to_frame(corners[2])};
  box_ = raster.box(p);
  // A parallel projection is the same algebra on the plane (x, y, 1).
  std::array<Vec3d, 3> q = p;
  if (raster.parallel()) {
    for (Vec3d& corner : q) corner.z = 1;
  }
  edges_ = {cross(q[1], q[2]), cross(q[2], q[0]), cross(q[0], q[1])};
  const double det = dot(q[0], edges_[0]);
  if (det == 0 || !std::isfinite(det)) return false;
  // At direction v the weights of the corners are edge.v / det. Finite eye: their sum is 1 / distance.
  // Eye at infinity: they sum to 1 and interpolate the corners' depths.
  near_ = raster.parallel() ? -(p[0].z * edges_[0] + p[1].z * edges_[1] + p[2].z * edges_[2])
                            : edges_[0] + edges_[1] + edges_[2];
  near_ = 1 / det * near_;
  if (det < 0) {
    for (Vec3d& edge : edges_) edge = -edge;
  }
  return true;
}

bool Footprint::set_sphere(const Sphere& sphere, const Raster& raster) {
  if (!(sphere.radius > 0)) return false;
  std::array<Vec3d, 8> cube;
  for (std::size_t k = 0; k < cube.size(); ++k) {
    const Vec3d sign{k & 1 ? 1.0 : -1.0, k & 2 ? 1.0 : -1.0, k & 4 ? 1.0 : -1.0};
    cube[k] = raster.to_frame(sphere.center + sphere.radius * sign);
  }
  sphere_ = sphere;
  box_ = raster.box(cube);
  return true;
}

std::optional<double> Footprint::nearness(const Raster& raster, const Vec3d& centre) const {
  if (sphere_) {
    const auto distance = sphere_distance(*sphere_, raster.ray_origin(centre), raster.ray_direction(centre));
    if (!distance) return std::nullopt;
    return raster.parallel() ? -*distance : 1 / *distance;
  }
  for (const Vec3d& edge : edges_) {
    if (!(dot(edge, centre) >= 0)) return std::nullopt;
  }
  const double value = dot(near_, centre);
  const bool in_front = raster.parallel() ? value < 0 : value > 0;
  if (!in_front) return std::nullopt;
  return value;
}

double Footprint::cosine(const Scene& scene, const Raster& raster, const Vec3d& centre) const {
  const Vec3d origin = raster.ray_origin(centre), direction = raster.ray_direction(centre);
  if (sphere_) {
    const double distance = sphere_distance(*sphere_, origin, direction).value_or(0);
    return cosine_between(origin + distance * direction - sphere_->center, direction);
  }
  const Vec3d a = scene.corner(id_, 0);
  return cosine_between(cross(scene.corner(id_, 1) - a, scene.corner(id_, 2) - a), direction);
}

}  // namespace provis
