#pragma once
// The solid that the rays of a beam sweep, and what is left of triangles and edges in it.

#include <array>
#include <cstdint>
#include <vector>

#include "predicates/formulas.hpp"
#include "predicates/interval.hpp"
#include "src/offset/face.hpp"

namespace provis::offset {

using Point = Vec3<Interval>;

/// normal·p - least >= 0 inside.
struct HalfSpace {
  Point normal;
  Interval least;
};

inline Interval height(const HalfSpace& h, const Point& p) { return dot(h.normal, p) - h.least; }

/// A corner of a polygon: an enclosure of a point in the triangle's plane.
struct Corner {
  Point at;
  std::int8_t input = -1;  ///< which corner of the triangle it is, without rounding; -1 where it was cut
};

/// A convex part of a triangle that holds all of it that lies in a shaft; perhaps more, never less.
struct Polygon {
  static constexpr std::size_t most = 12;
  std::array<Corner, most> corners;
  std::uint8_t size = 0;

  /// Which corners certainly lie outside of the half space.
  enum class Outside { none, some, all };
  Outside outside(const HalfSpace& h) const;

  /// Cuts off what certainly lies outside, and says how much that was. A cut that would need too many corners
  /// is left out.
  Outside clip(const HalfSpace& h);
};

Polygon whole(const Vec3d& a, const Vec3d& b, const Vec3d& c);

/// Rays from a face's rectangle in the directions of a rectangle of a raster. The solid that they sweep is
/// convex, and lies inside these half spaces.
class Shafts {
 public:
  explicit Shafts(const Frame& frame);

  enum : std::size_t { right, left, above, below, outward, forward, count };
  using Spaces = std::array<HalfSpace, count>;

  /// Beyond the borders of the rectangle, beyond the face, and not before the nearest viewpoint.
  Spaces around(const Face& face, const Window& directions) const;

  /// Whether the direction certainly belongs to a rectangle of directions.
  bool holds(const Window& directions, const Point& d) const;

  /// Grows along every ray of the raster, and by the same measure for all of them.
  Interval depth(const Point& p) const { return dot(z_, p); }

 private:
  Point x_, y_, z_;  ///< frame coordinates times one positive number
};

/// Whether certainly no point of the closed segment lies in all half spaces at once.
bool misses(const Vec3d& a, const Vec3d& b, const Shafts::Spaces& spaces);

}  // namespace provis::offset
