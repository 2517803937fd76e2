#pragma once
// Where one ray meets one triangle (R3, R4, R6), in exact numbers.

#include <gmpxx.h>

#include <array>
#include <optional>
#include <vector>

#include "provis/scene.hpp"
#include "tests/support/exact.hpp"

namespace provis::test {

using Rational = mpq_class;

/// A triangle of positive area (R3), in integers by one common scale.
struct Surface {
  PrimitiveId id = 0;
  std::array<Integer3, 3> corner;
  Integer3 normal;  ///< towards the front
  bool single_sided = false, occludes = false;

  /// Whether the other one lies in this one's plane.
  bool is_coplanar_with(const Surface& other) const;
};

/// Those triangles of a scene that have an area, in id order.
std::vector<Surface> surfaces_of(const SceneArrays& scene, const CommonScale& scale);

/// It starts in origin / weight, weight > 0; distances are counted in units of the direction.
struct ExactRay {
  Integer3 origin;
  Integer weight;
  Integer3 direction;
};

struct ExactHit {
  const Surface* surface = nullptr;
  Rational distance;    ///< > 0
  bool inside = false;  ///< in the relative interior
};

/// Nothing where the ray misses the closed triangle, where the triangle's plane holds the ray's origin (R6),
/// or where a culled side is met (R4).
std::optional<ExactHit> hit(const Surface& surface, const ExactRay& ray);

/// Whether the ray's origin lies on the closed triangle.
bool starts_on(const Surface& surface, const ExactRay& ray);

/// What decides a hit, as numbers whose signs matter; each is affine in the ray's origin while the weight
/// is 1.
struct HitNumbers {
  Integer across;  ///< normal . direction: 0 where the ray is parallel to the plane
  Integer away;    ///< normal . (corner - origin): the distance, times across
  std::array<Integer, 3>
      edge;  ///< >= 0 on the triangle's side of each edge; they mean nothing if across is 0
};

HitNumbers numbers(const Surface& surface, const ExactRay& ray);

}  // namespace provis::test
