#pragma once
// A point of dyadic coordinates, and whether triangles hold it.

#include <memory>

#include "provis/scene.hpp"
#include "provis/visible_set.hpp"

namespace provis {

class DyadicPoint {
 public:
  explicit DyadicPoint(const Vec3<Dyadic>& p);
  ~DyadicPoint();

  /// Whether the closed triangle, of positive area, holds the point. Exact.
  bool lies_on(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;

 private:
  struct Numbers;
  std::unique_ptr<Numbers> numbers_;
};

/// Whether the point lies on an occluding triangle (closed). Exact.
bool on_occluder(const Scene& scene, const Vec3<Dyadic>& p);

}  // namespace provis
