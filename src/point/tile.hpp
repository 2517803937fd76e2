#pragma once
// A rectangle of the window: its corner rays, its border lines, and itself as a cell.

#include <array>

#include "predicates/signs.hpp"
#include "src/point/cell.hpp"

namespace provis {

struct Tile {
  Window window;
  std::array<Direction, 4> corners;  ///< counter-clockwise in (x, y), from (x0, y0)
  std::array<Line, 4> borders;       ///< left, bottom, right, top; positive inside
};

/// The window coordinates of a ray, rounded: good enough to choose a sample by.
inline Vec3d window_coordinates(const ViewGeometry& g, const Vec3d& ray) {
  const Vec3d r = project_vector<double>(g, g.right), u = project_vector<double>(g, g.up);
  const Vec3d c = frame_center<double>(g);
  const double w = dot(ray, cross(r, u));
  return {dot(ray, cross(u, c)) / w, dot(ray, cross(c, r)) / w, 0};
}

/// The ray through window coordinates that are taken as exact.
template <Arithmetic A>
Direction window_direction(const Signs<A>& signs, const Vec3d& at) {
  Direction d;
  d.kind = DirectionKind::window;
  d.numbers = at;
  d.approx = signs.shadow(d);
  return d;
}

template <Arithmetic A>
Tile make_tile(const Signs<A>& signs, const Window& w) {
  Tile t;
  t.window = w;
  const double xs[4] = {w.x0, w.x1, w.x1, w.x0}, ys[4] = {w.y0, w.y0, w.y1, w.y1};
  const double at[4] = {w.x0, w.y0, w.x1, w.y1};
  for (std::size_t k = 0; k < 4; ++k) {
    t.corners[k] = window_direction(signs, {xs[k], ys[k], 0});
    t.borders[k].kind = k % 2 == 0 ? LineKind::x_border : LineKind::y_border;
    t.borders[k].negated = k >= 2;
    t.borders[k].at = at[k];
    t.borders[k].approx = signs.shadow(t.borders[k]);
  }
  return t;
}

/// The tile as a cell. Around it the border lines follow each other counter-clockwise as seen in the three
/// ray coordinates, which is clockwise in (x, y) for a frame of negative handedness.
inline Cell make_cell(const Tile& t, Sign handedness) {
  Cell c;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t border = handedness == Sign::positive ? k : (4 - k) % 4;
    const std::size_t corner = handedness == Sign::positive ? k : 3 - k;
    c.lines.push_back({&t.borders[border], false});
    c.vertices.push_back(t.corners[corner]);
  }
  return c;
}

}  // namespace provis
