#pragma once
// Places inside fragments: rounded ones, to be looked at by certain signs.

#include <cmath>

#include "src/point/looks.hpp"
#include "src/point/polygon.hpp"
#include "src/point/tile.hpp"

namespace provis {

/// A point about the middle of the facet's part in the rectangle; NaN where none was found.
Vec3d middle_of_fragment(const Facet& f, const Window& w);

/// Whether the window ray lies strictly inside the cell; ask(line, ray) says on which side of a line it lies.
template <Arithmetic A, class Ask>
bool inside_by(const Signs<A>& signs, const Cell& cell, const Vec3d& at, const Ask& ask) {
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return false;
  const Direction ray = window_direction(signs, at);
  return std::all_of(cell.lines.begin(), cell.lines.end(), [&](const Side& l) {
    return ask(*l.line, ray) == (l.negated ? Sign::negative : Sign::positive);
  });
}

/// The signs are asked.
template <Arithmetic A>
bool certainly_inside(Signs<A>& signs, const Cell& cell, const Vec3d& at) {
  return inside_by(signs, cell, at, [&](const Line& l, const Direction& d) { return signs.side(l, d); });
}

/// Only where an answer is cheap; false otherwise.
template <Arithmetic A>
bool quickly_inside(Signs<A>& signs, const Cell& cell, const Vec3d& at) {
  return inside_by(signs, cell, at,
                   [&](const Line& l, const Direction& d) { return signs.quick_side(l, d); });
}

/// About the middle of the cell's corners: rounded.
template <Arithmetic A>
Vec3d middle_of(const Signs<A>& signs, const Cell& cell) {
  Vec3d sum;
  for (const Direction& v : cell.vertices) sum = sum + window_coordinates(signs.geometry(), v.approx.v);
  return (1.0 / static_cast<double>(cell.vertices.size())) * sum;
}

}  // namespace provis
