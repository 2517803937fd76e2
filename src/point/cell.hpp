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
template <class SideOf, class Vertex>
struct ConvexCell {
  boost::container::small_vector<SideOf, 8> lines;
  boost::container::small_vector<Vertex, 8> vertices;

  bool empty() const { return lines.size() < 3; }
};

using Cell = ConvexCell<Side, Direction>;

using CellSigns = boost::container::small_vector<Sign, 12>;

/// Puts into `out`, which is empty, the part of the cell on one side of a line, given the signs of its
/// vertices (some of both kinds) and which are wanted. `border` is the line or its opposite, positive in the
/// part; meet(l, m) makes the vertex where line l gives way to line m.
template <class SideOf, class Vertex, class Meet>
void cut_out(const ConvexCell<SideOf, Vertex>& cell, SideOf border, const CellSigns& s, Sign wanted,
             const Meet& meet, ConvexCell<SideOf, Vertex>& out) {
  const std::size_t n = cell.lines.size();
  // Line k runs from vertex k - 1 to vertex k; it stays where it reaches into the wanted side.
  const auto stays = [&](std::size_t k) { return s[(k + n - 1) % n] == wanted || s[k] == wanted; };
  for (std::size_t k = 0; k < n; ++k) {
    if (!stays(k)) continue;
    const std::size_t next = (k + 1) % n;
    out.lines.push_back(cell.lines[k]);
    if (stays(next) && s[k] == wanted) {
      out.vertices.push_back(cell.vertices[k]);
      continue;
    }
    // The boundary leaves the wanted side here: the cutting line takes over up to where it comes back.
    std::size_t back = next;
    while (!stays(back)) back = (back + 1) % n;
    const std::size_t before_back = (back + n - 1) % n;
    out.vertices.push_back(s[k] == Sign::zero ? cell.vertices[k] : meet(cell.lines[k], border));
    out.lines.push_back(border);
    out.vertices.push_back(s[before_back] == Sign::zero ? cell.vertices[before_back]
                                                        : meet(border, cell.lines[back]));
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
  cut_out(
      cell, wanted == Sign::positive ? h : -h, s, wanted, [&](Side l, Side m) { return meet(l, m); }, out);
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
