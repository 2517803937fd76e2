#pragma once
// Rays from random viewpoints of a cell to random points of a triangle, or from close by: what they prove.

#include <optional>
#include <utility>

#include "predicates/exact_number.hpp"
#include "predicates/view_geometry.hpp"
#include "provis/cell.hpp"
#include "provis/visible_set.hpp"
#include "src/scene/certain_ray.hpp"
#include "src/scene/random.hpp"

namespace provis {

/// Guarantee:  a witness is one by R11, decided exactly: it starts in the closed cell on no occluder, leads
///             into the closed window, hits its triangle in the relative interior from a side that it has,
///             and no occluder outside of the triangle's plane meets it up to there
class RandomRays {
 public:
  RandomRays(const Scene& scene, const ViewCell& cell);

  /// The first witness among so many rays aimed at the triangle; the same for the same seed.
  std::optional<Witness> aim_at(PrimitiveId id, int rays, std::uint64_t seed) const;

  /// The first witness among rays from viewpoints just before and behind points of a triangle that meets the
  /// cell.
  std::optional<Witness> from_close_by(PrimitiveId id) const;

 private:
  struct Ray;

  std::optional<Witness> prove(PrimitiveId id, const Vec3d& start, const Vec3d& towards) const;
  std::pair<Vec3d, Vec3d> any_ray(PrimitiveId id, Random& random) const;
  RaySigns<ExactNumber> signs(const Ray& ray, PrimitiveId t) const;
  std::optional<Sign> reaches(RaySigns<ExactNumber>& signs, PrimitiveId t) const;
  bool hits(const Ray& ray, PrimitiveId id) const;
  bool in_window(const Vec3d& direction) const;
  bool blocked(const Ray& ray, PrimitiveId target) const;
  bool in_the_way(const Ray& ray, PrimitiveId occluder, PrimitiveId target) const;
  bool on_occluder(const Vec3d& p) const;
  bool coplanar(PrimitiveId a, PrimitiveId b) const;

  const Scene& scene_;
  const ViewCell& cell_;
  BoxTree tree_;
  std::optional<ViewGeometry> geometry_;  ///< of the window
};

}  // namespace provis
