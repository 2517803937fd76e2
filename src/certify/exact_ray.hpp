#pragma once
// One ray of exact numbers, and what can be said of it and a triangle with certainty.

#include <CGAL/Interval_nt.h>

#include "predicates/exact_number.hpp"
#include "predicates/interval.hpp"
#include "predicates/view_geometry.hpp"
#include "provis/scene.hpp"
#include "provis/visible_set.hpp"
#include "src/scene/box_tree.hpp"

namespace provis {

/// The signs of a RayHit (predicates/ray_hit.hpp).
struct Passage {
  Sign passes[3];
  Sign along;
  Sign reach;
};

/// The ray of a witness. A RoundUp guard must be alive while it is used.
class ExactRay {
 public:
  /// Throws:     Error::rejected if a number cannot be read or the direction is zero
  explicit ExactRay(const Witness& witness);

  const Vec3<ExactNumber>& origin() const { return origin_; }
  const Vec3<ExactNumber>& direction() const { return direction_; }

  Passage passage(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;

  /// The sign of (distance of the hit on the second triangle's plane) - (that on the first's). Requires: both
  /// have along != 0.
  Sign compare(const Scene& scene, std::size_t first, std::size_t second) const;

  /// Whether the ray starts on the closed triangle; on one of zero area it never does.
  bool starts_on(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;

  /// False only if the ray certainly misses the box.
  bool may_meet(const Box& box) const;

 private:
  Vec3<ExactNumber> origin_, direction_;
  Vec3<Interval> origin_bounds_, direction_bounds_;
};

/// Whether a ray of a finite eye in this direction, or one of an eye at infinity through this point seen from
/// the eye, passes the closed window on the viewer's side.
bool passes_window(const ViewGeometry& g, const Window& window, const Vec3<ExactNumber>& ray);

/// Whether both triangles, neither of zero area, lie in one plane.
bool coplanar(const Scene& scene, std::size_t first, std::size_t second);

}  // namespace provis
