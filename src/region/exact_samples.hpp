#pragma once
// What is visible at samples of the camera offset space, exactly (R10).

#include <optional>
#include <vector>

#include "provis/cell.hpp"
#include "src/offset/face.hpp"
#include "src/region/point_queries.hpp"
#include "src/scene/progress_meter.hpp"

namespace provis {

/// The samples of a cell's rasters, one at the centre of each pixel, each resolved by the exact from-point
/// engine with the eye at infinity: what is visible along the direction from an open set of the face's
/// points.
///
/// R10 and R10° differ in one way here. On an open set of offsets a triangle is hit in its relative interior,
/// and what is hit at the same distance lies in its plane; but the offset may lie on an occluder in the plane
/// of the face, which has no hits from there (R6) and yet takes the viewpoint (R9).
class ExactSamples {
 public:
  ExactSamples(const Scene& scene, const ViewCell& cell, const Context& context)
      : scene_(scene),
        cell_(cell),
        queries_(scene, context),
        shown_(scene.primitive_count(), 0),
        proofs_(shown_.size()) {}

  /// Returns the number of samples.
  std::uint64_t look(const PixelGrid& pixels, ProgressMeter& meter);

  /// Whether some sample shows it (R10).
  bool shows(PrimitiveId id) const { return shown_[id]; }
  /// A ray that proves it (R10°), where one was found.
  const std::optional<Witness>& proof(PrimitiveId id) const { return proofs_[id]; }
  const QueryStats& stats() const { return queries_.stats(); }

 private:
  void look_along(const offset::Face& face, const std::vector<offset::Face>& free, const Vec3d& direction);
  bool prove(const offset::Face& part, const Vec3d& direction, int halvings);

  const Scene& scene_;
  const ViewCell& cell_;
  PointQueries queries_;
  std::vector<char> shown_;
  std::vector<std::optional<Witness>> proofs_;
};

}  // namespace provis
