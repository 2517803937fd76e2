#pragma once
// Rays from random viewpoints of a cell to random points of a triangle: what they prove.

#include <optional>

#include "provis/cell.hpp"
#include "provis/visible_set.hpp"
#include "src/scene/box_tree.hpp"

namespace provis {

/// Guarantee:  a witness is one by R11, decided exactly: it starts in the closed cell on no occluder, leads
///             into the closed window, hits its triangle in the relative interior from a side that it has,
///             and no occluder outside of the triangle's plane meets it up to there
class RandomRays {
 public:
  RandomRays(const Scene& scene, const ViewCell& cell) : scene_(scene), cell_(cell), tree_(scene) {}

  /// The first witness among so many rays aimed at the triangle; the same for the same seed.
  std::optional<Witness> aim_at(PrimitiveId id, int rays, std::uint64_t seed) const;

 private:
  struct Ray;

  bool hits(const Ray& ray, PrimitiveId id) const;
  bool in_window(const Vec3d& direction) const;
  bool blocked(const Ray& ray, PrimitiveId target) const;
  bool in_the_way(const Ray& ray, PrimitiveId occluder, PrimitiveId target) const;
  bool on_occluder(const Vec3d& p) const;
  bool coplanar(PrimitiveId a, PrimitiveId b) const;

  const Scene& scene_;
  const ViewCell& cell_;
  BoxTree tree_;
};

}  // namespace provis
