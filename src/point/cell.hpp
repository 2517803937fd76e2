#pragma once
// Convex cells of the image, held as cyclic lists of lines: nothing is ever divided or projected.

#include <boost/container/small_vector.hpp>

#include "predicates/signs.hpp"
#include "src/point/part_lines.hpp"

namespace provis {

/// A line or its opposite; cells lie on the positive side.
struct Side {
  const Line* line = nullptr;
  bool negated = false;

  Side operator-() const { return {line, !negated}; }
};

/// A convex cell with interior: vertex k is where line k meets line k + 1, on the ray of their cross
/// product. No two neighbours are the same line, and no line is there that bounds nothing.
struct Cell {
  boost::container::small_vector<Side, 8> lines;
  boost::container::small_vector<Direction, 8> vertices;

  bool empty() const { return lines.size() < 3; }
};

using CellSigns = boost::container::small_vector<Sign, 12>;

/// The way around the part of a convex cell on one side of a line, the border, given the signs of its n
/// vertices (some of both kinds) and which are wanted. Calls emit(l, v, crosses) for each line of the part,
/// in order: it is line l, or the border if l is n, and gives way to the next at vertex v or, if crosses,
/// where line v and the border cross.
template <class Emit>
void cut_around(std::size_t n, const CellSigns& s, Sign wanted, const Emit& emit) {
  // Line k runs from vertex k - 1 to vertex k; it stays where it reaches into the wanted side.
  const auto before = [n](std::size_t k) { return (k == 0 ? n : k) - 1; };
  const auto after = [n](std::size_t k) { return k + 1 == n ? 0 : k + 1; };
  const auto stays = [&](std::size_t k) { return s[before(k)] == wanted || s[k] == wanted; };
  for (std::size_t k = 0; k < n; ++k) {
    if (!stays(k)) continue;
    if (s[k] == wanted && stays(after(k))) {
      emit(k, k, false);
      continue;
    }
    // The boundary leaves the wanted side here: the border takes over up to where it comes back.
    std::size_t back = after(k);
    while (!stays(back)) back = after(back);
    emit(k, k, s[k] != Sign::zero);
    const bool touches = s[before(back)] == Sign::zero;
    emit(n, touches ? before(back) : back, !touches);
  }
}

/// Cuts cells. Vertices through which an input point's ray passes are kept as that point: a lower degree,
/// and identities known from structure.
template <Arithmetic A>
class CellCutter {
 public:
  CellCutter(Signs<A>& signs, ImagePoints<A>& points) : signs_(signs), points_(points) {}

  /// The side of each vertex; returns whether any is positive and whether any is negative.
  std::pair<bool, bool> classify(const Cell& cell, Side h, CellSigns& out);

  /// The part of the cell where h has the wanted sign, given the signs of its vertices (some of both kinds).
  Cell part(const Cell& cell, Side h, const CellSigns& vertex_signs, Sign wanted);

  /// The vertex where line l gives way to line m on the way around a cell.
  Direction meet(Side l, Side m);

 private:
  Signs<A>& signs_;
  ImagePoints<A>& points_;
};

template <Arithmetic A>
std::pair<bool, bool> CellCutter<A>::classify(const Cell& cell, Side h, CellSigns& out) {
  out.clear();
  bool positive = false, negative = false;
  for (const Direction& v : cell.vertices) {
    const Sign s = signs_.side(*h.line, v);
    out.push_back(h.negated ? -s : s);
    positive |= out.back() == Sign::positive;
    negative |= out.back() == Sign::negative;
  }
  return {positive, negative};
}

template <Arithmetic A>
Cell CellCutter<A>::part(const Cell& cell, Side h, const CellSigns& s, Sign wanted) {
  Cell out;
  const std::size_t n = cell.lines.size();
  const Side border = wanted == Sign::positive ? h : -h;
  cut_around(n, s, wanted, [&](std::size_t line, std::size_t vertex, bool crosses) {
    const Side of_line = line == n ? border : cell.lines[line];
    out.lines.push_back(of_line);
    if (!crosses)
      out.vertices.push_back(cell.vertices[vertex]);
    else
      out.vertices.push_back(line == n ? meet(border, cell.lines[vertex]) : meet(of_line, border));
  });
  return out;
}

template <Arithmetic A>
Direction CellCutter<A>::meet(Side l, Side m) {
  for (const std::uint32_t p : l.line->points) {
    if (p == no_id || (p != m.line->points[0] && p != m.line->points[1])) continue;
    // A vertex of a cell lies in the image, so of the point's ray and its opposite it is the one that does.
    const ImagePoint& point = points_[p];
    if (point.side == Sign::zero) break;
    Direction v = point.direction;
    if (point.side == Sign::negative) {
      v.negated = true;
      v.approx.v = -v.approx.v;
    }
    return v;
  }
  Direction v;
  v.kind = DirectionKind::crossing;
  v.lines[0] = l.line;
  v.lines[1] = m.line;
  v.negated = l.negated != m.negated;
  Approx a = cross(l.line->approx, m.line->approx);
  if (v.negated) a.v = -a.v;
  v.approx = prepare(a);
  return v;
}

}  // namespace provis
