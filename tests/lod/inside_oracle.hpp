#pragma once
// Whether a point is inside of a closed surface: by rays over rational numbers, held against every triangle.
// Shares no code with the engine.

#include <gmpxx.h>

#include "tests/lod/solids.hpp"

namespace provis::test {

using Exact3 = Vec3<mpq_class>;

Exact3 exact_point(const Vec3d& p);

class InsideOracle {
 public:
  InsideOracle(const SceneArrays& chain, std::uint64_t seed) : chain_(chain), random_(seed) {}

  /// Not zero around p, or p lies on a triangle.
  bool by_any_side(const Exact3& p);

  /// For a point of a triangle of this normal: from both sides, rays have met a side that is there at or
  /// before p. Nothing is said (true) of points on edges, or on triangles that cross the plane.
  bool by_fronts(const Exact3& p, const Exact3& normal);

 private:
  enum class Place { off, inside, border };
  Place place(const Exact3& p, std::size_t t) const;
  Exact3 normal(std::size_t t) const;
  Exact3 corner(std::size_t t, std::size_t k) const;
  /// Of points beside p, on the side that the direction leads to: turned until nothing is in doubt.
  int winding(const Exact3& p, const Exact3& towards);

  const SceneArrays& chain_;
  Random random_;
};

}  // namespace provis::test
