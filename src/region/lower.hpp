#pragma once
// The lower set of a view cell: what is proven to be visible from it.

#include <optional>
#include <vector>

#include "provis/cell.hpp"
#include "provis/point.hpp"
#include "src/offset/face.hpp"

namespace provis {

/// What was found so far: a witness for each primitive proven to be visible.
class LowerSet {
 public:
  LowerSet(const Scene& scene, const ViewCell& cell, const Context& context)
      : scene_(scene), cell_(cell), context_(context), witnesses_(scene.primitive_count()) {}

  bool holds(PrimitiveId id) const { return witnesses_[id].has_value(); }
  const std::vector<std::optional<Witness>>& witnesses() const { return witnesses_; }

  /// Exact from-point sets (R7) at viewpoints of the cell on no occluder. Returns how many primitives are
  /// new.
  std::uint64_t look_from(const std::vector<Vec3d>& viewpoints);

  /// One sample of the camera offset space per face and direction, exactly: everything that is visible along
  /// the direction from an open set of the face's points (R10°). The scene is seen in parallel projection
  /// through the face's rectangle. Returns how many primitives are new; counts the samples taken.
  std::uint64_t look_along(int directions, std::uint64_t& samples);

  /// Looks at one triangle from close by. Returns whether it was seen.
  bool look_at_contact(PrimitiveId id);

 private:
  std::uint64_t keep(const VisibleSet& set, bool check_origins);
  bool origin_is_free(const Witness& witness) const;

  const Scene& scene_;
  const ViewCell& cell_;
  const Context& context_;
  std::vector<std::optional<Witness>> witnesses_;
};

/// A sample of the camera offset space as a view: along the axis outward, x and y along the next two, from
/// every point of the face. Rays start in its plane exactly: the window's coordinates are the space's own.
PointView offset_sample_view(const offset::Face& face, double x, double y);
bool has_area(const offset::Face& face);

/// The view from a point in the directions of the cell.
PointView view_from(const ViewCell& cell, const Vec3d& eye);

}  // namespace provis
