#pragma once
// The triangles that rays from one face may hit, and the signs that are asked of them.

#include <optional>
#include <vector>

#include "predicates/sign.hpp"
#include "provis/scene.hpp"
#include "src/offset/seams.hpp"
#include "src/offset/shaft.hpp"

namespace provis::offset {

struct Facet {
  PrimitiveId id = 0;
  std::array<const Vec3d*, 3> p{};   ///< if faced: in the order in which viewpoints see det[p0, p1, p2] > 0
  std::array<std::uint32_t, 3> v{};  ///< numbers of Seams
  std::array<std::uint8_t, 3> edge{0, 1, 2};  ///< which edge of the triangle leads from p[k] to p[k + 1]
  bool faced = false;                         ///< the whole face lies on one side of the plane, and not in it
  bool opaque = false;
  bool occludes = false;  ///< faced, opaque, and seen from the side that it has
};

struct Facets {
  std::vector<Facet> all;
  std::uint64_t facing_unknown = 0;  ///< opaque triangles that are not faced
};

/// What rays that leave the face can hit: left out are triangles of zero area, in the plane of the face or
/// behind it, and those that show the face only a side that they do not have.
///
/// Guarantee:  exact. A RoundUp guard must be alive
Facets facets_of(const Scene& scene, const Seams& seams, const Face& face);

/// Which side of a faced triangle's plane a point lies on: positive beyond it, as seen from the face.
Sign beyond(const Facet& f, const Vec3d& p);
/// The same for an enclosure: nullopt where that cannot tell.
std::optional<Sign> beyond(const Facet& f, const Point& p);

/// The sign of det[a - o, b - o, p - o]: positive where p is seen from o on the inner side of the edge a b of
/// a faced triangle.
Sign turn(const Vec3d& a, const Vec3d& b, const Vec3d& p, const Vec3d& o);
Interval turn(const Vec3d& a, const Vec3d& b, const Point& p, const Point& o);

}  // namespace provis::offset
