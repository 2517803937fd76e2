#pragma once
// What a primitive covers of a picture, and how near it is there, in float64.
//
// A triangle is three edge functionals and a nearness functional of the homogeneous pixel direction
// (x, y, 1) in frame coordinates. Nothing is divided by a depth, so there is no near plane, and
// triangles that cross or surround the eye's plane need no clipping.

#include <array>
#include <optional>

#include "provis/scene.hpp"
#include "src/report/raster.hpp"

namespace provis {

/// Where one triangle or sphere is seen.
class Footprint {
 public:
  /// Nothing where the primitive has no area in this frame, lies behind it, or beside the picture.
  static std::optional<Footprint> of(const Scene& scene, PrimitiveId id, const Raster& raster);

  PrimitiveId id() const { return id_; }
  const PixelBox& box() const { return box_; }

  /// A number that grows towards the eye, or nothing where the primitive is not hit.
  std::optional<double> nearness(const Raster& raster, const Vec3d& centre) const;

  /// Cosine between the surface's normal and the line of sight, both in world coordinates.
  double cosine(const Scene& scene, const Raster& raster, const Vec3d& centre) const;

 private:
  bool set_triangle(const std::array<Vec3d, 3>& corners, const Raster& raster);
  bool set_sphere(const Sphere& sphere, const Raster& raster);

  PrimitiveId id_ = 0;
  PixelBox box_;
  std::array<Vec3d, 3> edges_{};  ///< all three are >= 0 where a triangle is hit
  Vec3d near_;                    ///< the triangle's nearness
  std::optional<Sphere> sphere_;
};

}  // namespace provis
