#pragma once
// The lower set of a view cell: what is proven to be visible from it.

#include <optional>
#include <vector>

#include "provis/cell.hpp"
#include "provis/point.hpp"
#include "src/offset/face.hpp"
#include "src/region/point_queries.hpp"
#include "src/scene/progress_meter.hpp"

namespace provis {

/// What was found so far: a witness for each primitive proven to be visible.
class LowerSet {
 public:
  LowerSet(const Scene& scene, const ViewCell& cell, const Context& context)
      : scene_(scene), cell_(cell), queries_(scene, context), witnesses_(scene.primitive_count()) {}

  bool holds(PrimitiveId id) const { return witnesses_[id].has_value(); }
  const std::vector<std::optional<Witness>>& witnesses() const { return witnesses_; }
  const QueryStats& stats() const {
    return queries_.stats();
  }  ///< of the from-point queries: signs, nodes, leaves

  /// Exact from-point sets (R7) at viewpoints of the cell on no occluder. Returns how many primitives are
  /// new.
  std::uint64_t look_from(const std::vector<Vec3d>& viewpoints, ProgressMeter& meter);

  /// Continuously along the edges and diagonals of the cell, at the centres of `pixels` squared for each
  /// frame: what is visible there for some time (R10°). Returns how many primitives are new; counts the
  /// segments.
  std::uint64_t look_along_paths(int pixels, std::uint64_t& paths, ProgressMeter& meter);

  /// Samples of the camera offset space (samples.hpp), `directions` squared of them for each face, through
  /// the parts on which no occluder lies: everything that is visible along the direction from an open set of
  /// their points (R10°). Returns how many primitives are new; counts the samples taken.
  std::uint64_t look_along(int directions, std::uint64_t& samples, ProgressMeter& meter);

  /// So many random rays at each of these (random_rays.hpp). Returns how many primitives are new.
  std::uint64_t aim_at(const std::vector<PrimitiveId>& ids, int rays, std::uint64_t seed,
                       ProgressMeter& meter);

  /// Rays from close by at each of these, which meet the cell.
  void look_at_contacts(const std::vector<PrimitiveId>& ids);

 private:
  std::uint64_t keep(const VisibleSet& set, bool check_origins);
  std::vector<Vec3d> sample_directions(const offset::Face& face, int count) const;

  const Scene& scene_;
  const ViewCell& cell_;
  PointQueries queries_;
  std::vector<std::optional<Witness>> witnesses_;
};

/// The view from a point in the directions of the cell.
PointView view_from(const ViewCell& cell, const Vec3d& eye);

}  // namespace provis
