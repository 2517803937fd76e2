#pragma once
// The drawing board of the bird's-eye picture: where a point of the scene lies on it.

#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "src/report/marks.hpp"
#include "src/report/raster.hpp"

namespace provis {

/// A parallel projection from above along one axis: the dominant axis of the first frame's up vector.
/// Scene and eye fit into the picture; both directions have the same scale.
class Plan {
 public:
  Plan(const Scene& scene, const PointView& view, int width, int height);

  const Raster& raster() const { return raster_; }
  PixelPoint point(const Vec3d& p) const;
  /// The picture's direction of a direction in the scene, of length 1, or 0 where it points up or down.
  PixelPoint direction(const Vec3d& d) const;

 private:
  Raster raster_;
  Vec3d right_, ahead_;
};

}  // namespace provis
