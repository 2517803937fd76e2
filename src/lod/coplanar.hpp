#pragma once
// Triangles of one plane.

#include <array>

#include "predicates/sign.hpp"
#include "provis/vec3.hpp"

namespace provis::lod {

using Corners = std::array<Vec3d, 3>;

/// Exact; a RoundUp guard must be alive. All triangles are of some area, and in the plane of the first.
class Coplanar {
 public:
  explicit Coplanar(const Corners& t);

  /// Whether the closed triangle t holds all of p.
  bool covers(const Corners& t, const Corners& p) const;

  /// Whether they have no inner points in common: an edge of one has the other on its far side.
  bool apart(const Corners& t, const Corners& p) const;

 private:
  Sign turn(const Vec3d& a, const Vec3d& b, const Vec3d& p) const;
  bool beyond_an_edge(const Corners& t, const Corners& p) const;

  int i_ = 0, j_ = 1;  ///< the coordinates in which the plane is not seen edge-on
};

}  // namespace provis::lod
