#pragma once
// Lines and directions of the image, each with its definition (for certain signs) and its float64 shadow
// (for fast ones).

#include <cstdint>
#include <limits>

#include "predicates/approx.hpp"
#include "predicates/formulas.hpp"
#include "predicates/sign.hpp"

namespace provis {

inline constexpr std::uint32_t no_id = std::numeric_limits<std::uint32_t>::max();

/// Corners of a triangle in the order in which at_eye > 0.
struct Corners {
  const Vec3d* p[3] = {nullptr, nullptr, nullptr};
};

enum class LineKind : std::uint8_t { edge, x_border, y_border, image, depth, front };

/// A line of the image: a functional on rays, given by its definition.
struct Line {
  Approx approx;
  LineKind kind = LineKind::edge;
  bool negated = false;   ///< borders only: positive on the smaller side
  Corners first, second;  ///< edge: first.p[0] to first.p[1]; depth: two triangles; front: first
  double at = 0;          ///< borders: the window coordinate
  std::uint32_t points[2] = {no_id, no_id};  ///< ids of input points known to lie on the line
  std::uint32_t planes[2] = {no_id, no_id};  ///< depth: ids of both triangles
};

enum class DirectionKind : std::uint8_t { point, window, crossing, given };

/// A ray: through an input point, through window coordinates, along the crossing of two lines, or given.
struct Direction {
  ApproxDirection approx;
  DirectionKind kind = DirectionKind::given;
  bool negated = false;                       ///< point, crossing: the opposite of what the definition says
  std::uint32_t point_id = no_id;             ///< point
  const Vec3d* point = nullptr;               ///< point
  const Line* lines[2] = {nullptr, nullptr};  ///< crossing
  Vec3d numbers;                              ///< given: the ray itself; window: (x, y, -)
};

template <class N>
Vec3<N> evaluate(const ViewGeometry& g, const Line& l) {
  switch (l.kind) {
    case LineKind::edge:
      return edge_line<N>(g, *l.first.p[0], *l.first.p[1]);
    case LineKind::depth:
      return depth_line(g, triangle_plane<N>(g, *l.first.p[0], *l.first.p[1], *l.first.p[2]),
                        triangle_plane<N>(g, *l.second.p[0], *l.second.p[1], *l.second.p[2]));
    case LineKind::front:
      return depth_line(g, window_plane<N>(g),
                        triangle_plane<N>(g, *l.first.p[0], *l.first.p[1], *l.first.p[2]));
    case LineKind::x_border:
    case LineKind::y_border:
    case LineKind::image:
      break;
  }
  const Vec3<N> v = l.kind == LineKind::x_border   ? x_border<N>(g, l.at)
                    : l.kind == LineKind::y_border ? y_border<N>(g, l.at)
                                                   : image_side<N>(g);
  return l.negated == (g.handedness == Sign::positive) ? -v : v;
}

template <class N>
Vec3<N> evaluate(const ViewGeometry& g, const Direction& d) {
  switch (d.kind) {
    case DirectionKind::point: {
      const Vec3<N> v = project_point<N>(g, *d.point);
      return d.negated ? -v : v;
    }
    case DirectionKind::window:
      return window_ray<N>(g, d.numbers.x, d.numbers.y);
    case DirectionKind::crossing: {
      const Vec3<N> v = cross(evaluate<N>(g, *d.lines[0]), evaluate<N>(g, *d.lines[1]));
      return d.negated ? -v : v;
    }
    case DirectionKind::given:
      break;
  }
  return numbers<N>(d.numbers);
}

/// Whether the direction is known to lie on the line from indices alone, before any arithmetic.
bool on_line_by_structure(const Line& line, const Direction& direction);

/// Whether it is known from coordinates that are equal: points on one axis-parallel line, in one plane across
/// an axis, or in such a plane through the eye. For zeros that the filter has left over.
bool on_line_by_coordinates(const ViewGeometry& geometry, const Line& line, const Direction& direction);

/// Whether two triangles are known in the same way to lie in one plane.
bool coplanar_by_coordinates(const Corners& first, const Corners& second);

}  // namespace provis
