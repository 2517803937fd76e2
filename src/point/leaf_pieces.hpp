#pragma once
// Convex pieces of a leaf, cut by certain signs: corners and lines are float64 with bounds, and get their
// definitions only where those cannot tell.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "src/point/leaf_corner.hpp"
#include "src/point/leaf_lines.hpp"
#include "src/point/tile.hpp"

namespace provis {

/// A convex piece: a range of LeafPieces' rings. It is a value that costs nothing to copy.
struct LeafPiece {
  Window box;
  std::uint32_t first = 0, size = 0;
};

/// The lines and corners of all pieces that come from one tile.
template <Arithmetic A>
class LeafPieces {
 public:
  LeafPieces(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines, CellCutter<A>& cutter,
             const Tile& tile);

  /// Forgets every line, corner and piece but the tile's; returns the whole tile.
  LeafPiece begin_anew();

  /// The facet that beside, behind and edge speak of.
  void begin(std::uint32_t facet);
  /// Whether it certainly has nothing in the piece but contact.
  bool beside(const LeafPiece& piece);
  /// Whether it is certainly behind the other all over the piece.
  bool behind(std::uint32_t other, const LeafPiece& piece) const;
  /// Positive on the facet's side of its edge k.
  LeafSide edge(std::uint32_t k);

  /// Positive on what is left of a facet that the front plane cuts.
  LeafSide front(std::uint32_t facet);
  /// Positive where the first is strictly nearer. Requires: not in one plane.
  LeafSide depth(std::uint32_t near, std::uint32_t far);
  bool in_one_plane(std::uint32_t a, std::uint32_t b, const LeafPiece& where);

  /// The side of each corner; returns whether any is positive and whether any is negative.
  std::pair<bool, bool> classify(const LeafPiece& piece, LeafSide side, CellSigns& out);
  /// The parts on the positive and on the negative side, given the signs of the corners (some of both kinds).
  std::pair<LeafPiece, LeafPiece> split(const LeafPiece& piece, LeafSide side, const CellSigns& signs);

  Cell definition(const LeafPiece& piece);

 private:
  struct Bound {
    LeafSide line;
    std::uint32_t corner;  ///< where it gives way to the next
  };
  struct Crossings {  ///< of one line with two of a piece: the corners that its parts have in common
    LeafSide lines[2];
    std::uint32_t corners[2];
    int count = 0;
  };

  LeafSide add(const LeafBand& band);
  Sign sign(std::uint32_t band, std::uint32_t corner);
  std::optional<Sign> known_sign(std::uint32_t band, LeafCorner& c);
  CornerMark ask(std::uint32_t k, LeafCorner& c);
  static Predicate predicate(const LeafBand& band);
  LeafPiece part(const LeafPiece& piece, LeafSide border, const CellSigns& signs, Sign wanted,
                 Crossings& crossings);
  std::uint32_t crossing(LeafSide line, LeafSide border, bool leaving, Crossings& made);
  Window box_of(const LeafPiece& piece) const;
  template <class Test>
  bool all_corners(const LeafPiece& piece, const Test& test) const;
  Side definition(LeafSide side);
  const Direction& definition_of(LeafCorner& c);

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  LeafLines<A>& lines_;
  CellCutter<A>& cutter_;
  const Tile& tile_;
  std::vector<LeafBand> bands_;
  std::uint32_t facet_ = 0;
  std::uint32_t inserted_ = 0;   ///< facets so far, of which facet_ is the last
  std::uint32_t edges_ = no_id;  ///< its edges, which most facets never need
  std::vector<LeafCorner> corners_;
  std::vector<Bound> rings_;  ///< of all pieces
  std::vector<Direction> directions_;
};

template <Arithmetic A>
LeafPieces<A>::LeafPieces(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines, CellCutter<A>& cutter,
                          const Tile& tile)
    : signs_(signs), facets_(facets.facets), lines_(lines), cutter_(cutter), tile_(tile) {
  const Window& w = tile.window;
  const double xs[4] = {w.x0, w.x1, w.x1, w.x0}, ys[4] = {w.y0, w.y0, w.y1, w.y1};
  const WindowFunction borders[4] = {{1, 0, -w.x0, 0}, {0, 1, -w.y0, 0}, {-1, 0, w.x1, 0}, {0, -1, w.y1, 0}};
  for (std::uint32_t k = 0; k < 4; ++k) {
    // The value of a border's function is rounded twice, of numbers no larger than these.
    const double size = std::fabs(w.x0) + std::fabs(w.x1) + std::fabs(w.y0) + std::fabs(w.y1);
    WindowFunction function = borders[k];
    function.error = evaluation_error(size) + underflow_bound;
    LeafBand band(function);
    band.kind = k % 2 == 0 ? LineKind::x_border : LineKind::y_border;
    band.facet = k;
    add(band);
  }
  const bool positive = signs.geometry().handedness == Sign::positive;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t border = positive ? k : (4 - k) % 4, at = positive ? k : 3 - k;
    const std::uint32_t following = positive ? (k + 1) % 4 : 3 - k;
    LeafCorner corner;
    corner.x = xs[at];
    corner.y = ys[at];
    corner.error = 0;
    corner.sides[0] = 2 * border;
    corner.sides[1] = 2 * following;
    corner.direction = k;
    directions_.push_back(tile.corners[at]);
    corners_.push_back(corner);
    rings_.push_back({2 * border, k});
  }
}

template <Arithmetic A>
LeafPiece LeafPieces<A>::begin_anew() {
  bands_.resize(4);
  corners_.resize(4);
  directions_.resize(4);
  rings_.resize(4);
  return {tile_.window, 0, 4};
}

template <Arithmetic A>
LeafSide LeafPieces<A>::add(const LeafBand& band) {
  bands_.push_back(band);
  return static_cast<LeafSide>(2 * (bands_.size() - 1));
}

template <Arithmetic A>
void LeafPieces<A>::begin(std::uint32_t facet) {
  facet_ = facet;
  ++inserted_;
  edges_ = no_id;
}

template <Arithmetic A>
LeafSide LeafPieces<A>::edge(std::uint32_t k) {
  if (edges_ == no_id) {
    const Facet& f = facets_[facet_];
    edges_ = static_cast<std::uint32_t>(bands_.size());
    for (std::uint32_t i = 0; i < 3; ++i) {
      LeafBand& band = bands_.emplace_back(f.inside[i]);
      band.facet = facet_;
      band.other = i;
      band.hold(f.points[i], f.points[(i + 1) % 3]);
    }
  }
  return 2 * (edges_ + k);
}

template <Arithmetic A>
bool LeafPieces<A>::beside(const LeafPiece& piece) {
  const Facet& f = facets_[facet_];
  if (!overlap(f.box, piece.box)) return true;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (f.inside[k].highest(piece.box) < 0) return true;
    if (f.inside[k].lowest(piece.box) > 0) continue;
    edge(k);
    const auto not_inside = [&](LeafCorner& c) {
      const CornerMark mark = ask(k, c);
      return mark == CornerMark::negative || mark == CornerMark::zero;
    };
    bool outside = true;
    for (std::uint32_t i = piece.first; outside && i < piece.first + piece.size; ++i)
      outside = not_inside(corners_[rings_[i].corner]);
    if (outside) return true;
  }
  return false;
}

template <Arithmetic A>
bool LeafPieces<A>::behind(std::uint32_t other, const LeafPiece& piece) const {
  const Facet& f = facets_[facet_];
  if (!overlap(piece.box, f.box)) return false;
  const LeafBand farther(difference(facets_[other].depth, f.depth));
  if (farther.function.lowest(intersection(piece.box, f.box)) > 0) return true;
  // A bound here too under every policy.
  return all_corners(piece, [&](const LeafCorner& c) {
    return quick_sign<Arithmetic::chain>(farther, c) == Sign::positive;
  });
}

template <Arithmetic A>
template <class Test>
bool LeafPieces<A>::all_corners(const LeafPiece& piece, const Test& test) const {
  for (std::uint32_t i = piece.first; i < piece.first + piece.size; ++i)
    if (!test(corners_[rings_[i].corner])) return false;
  return true;
}

template <Arithmetic A>
std::pair<bool, bool> LeafPieces<A>::classify(const LeafPiece& piece, LeafSide side, CellSigns& out) {
  out.clear();
  bool positive = false, negative = false;
  for (std::uint32_t i = piece.first; i < piece.first + piece.size; ++i) {
    const Sign of_line = sign(side >> 1, rings_[i].corner), s = side & 1 ? -of_line : of_line;
    out.push_back(s);
    positive |= s == Sign::positive;
    negative |= s == Sign::negative;
  }
  return {positive, negative};
}

/// Of the line, not of its opposite.
template <Arithmetic A>
Sign LeafPieces<A>::sign(std::uint32_t band, std::uint32_t corner) {
  LeafCorner& c = corners_[corner];
  CornerMark* mark = nullptr;
  if (edges_ != no_id && band - edges_ < 3) {
    const CornerMark known = ask(band - edges_, c);
    if (known != CornerMark::open) return sign_of(known);
    mark = &c.marks[band - edges_];
  } else if (const std::optional<Sign> s = known_sign(band, c)) {
    return *s;
  }
  const Side side = definition(2 * band);
  const Sign of_side = signs_.side(*side.line, definition_of(c)), s = side.negated ? -of_side : of_side;
  if (mark != nullptr) *mark = mark_of(s);
  return s;
}

/// By structure, or by float64.
template <Arithmetic A>
std::optional<Sign> LeafPieces<A>::known_sign(std::uint32_t index, LeafCorner& c) {
  const LeafBand& band = bands_[index];
  if (known_zero(band, index, c)) {
    signs_.count(predicate(band), Tier::structure);
    return Sign::zero;
  }
  const std::optional<Sign> s = quick_sign<A>(band, c);
  if (!s) return s;
  signs_.count(predicate(band), Tier::filter);
  if constexpr (A == Arithmetic::doubles)
    if (signs_.geometry().checked) [[unlikely]] {
      const Side side = definition(2 * index);
      signs_.check(*side.line, definition_of(c), side.negated ? -*s : *s);
    }
  return s;
}

/// The facet's edge k at the corner. Corners are shared by neighbouring pieces, and asked several times of
/// each.
template <Arithmetic A>
CornerMark LeafPieces<A>::ask(std::uint32_t k, LeafCorner& c) {
  if (c.asked_by != inserted_) {
    c.asked_by = inserted_;
    c.marks.fill(CornerMark::unasked);
  }
  CornerMark& mark = c.marks[k];
  if (mark == CornerMark::unasked) {
    const std::optional<Sign> s = known_sign(edges_ + k, c);
    mark = s ? mark_of(*s) : CornerMark::open;
  }
  return mark;
}

template <Arithmetic A>
std::pair<LeafPiece, LeafPiece> LeafPieces<A>::split(const LeafPiece& piece, LeafSide side,
                                                     const CellSigns& s) {
  Crossings crossings;
  const LeafPiece positive = part(piece, side, s, Sign::positive, crossings);
  return {positive, part(piece, side ^ 1, s, Sign::negative, crossings)};
}

/// What is on one side of a line. `border` is the line or its opposite, positive in the part.
template <Arithmetic A>
LeafPiece LeafPieces<A>::part(const LeafPiece& piece, LeafSide border, const CellSigns& s, Sign wanted,
                              Crossings& crossings) {
  LeafPiece out;
  out.first = static_cast<std::uint32_t>(rings_.size());
  cut_around(piece.size, s, wanted, [&](std::size_t line, std::size_t corner, bool crosses) {
    const LeafSide of_line = line == piece.size ? border : rings_[piece.first + line].line;
    const std::uint32_t at =
        crosses ? crossing(rings_[piece.first + corner].line, border, line != piece.size, crossings)
                : rings_[piece.first + corner].corner;
    rings_.push_back({of_line, at});
  });
  out.size = static_cast<std::uint32_t>(rings_.size()) - out.first;
  out.box = box_of(out);
  return out;
}

/// Where a piece's line gives way to the border of a part, or the border to it. The other part has the
/// opposite border, and changes from one to the other in the opposite order: the same corner.
template <Arithmetic A>
std::uint32_t LeafPieces<A>::crossing(LeafSide line, LeafSide border, bool leaving, Crossings& made) {
  for (int k = 0; k < made.count; ++k)
    if (made.lines[k] == line) return made.corners[k];
  LeafCorner c;
  c.sides[0] = leaving ? line : border;
  c.sides[1] = leaving ? border : line;
  const LeafBand &a = bands_[line >> 1], &b = bands_[border >> 1];
  c.ends[0] = a.ends;
  c.ends[1] = b.ends;
  for (const std::uint32_t p : a.points)
    if (p != no_id && (p == b.points[0] || p == b.points[1])) c.point = p;
  place(c, a.function, b.function, tile_.window);
  corners_.push_back(c);
  const auto corner = static_cast<std::uint32_t>(corners_.size() - 1);
  if (made.count < 2) {  // rounded signs may cross more
    made.lines[made.count] = line;
    made.corners[made.count++] = corner;
  }
  return corner;
}

/// Corners lie in the tile.
template <Arithmetic A>
Window LeafPieces<A>::box_of(const LeafPiece& piece) const {
  Window box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (std::uint32_t i = piece.first; i < piece.first + piece.size; ++i) {
    const LeafCorner& c = corners_[rings_[i].corner];
    // The sum is rounded, by less than a part in 2^50 of it.
    const double r = c.error == 0 ? 0 : c.error + 4 * unit_roundoff * (std::fabs(c.x) + std::fabs(c.y));
    box.x0 = std::min(box.x0, c.x - r);
    box.x1 = std::max(box.x1, c.x + r);
    box.y0 = std::min(box.y0, c.y - r);
    box.y1 = std::max(box.y1, c.y + r);
  }
  return intersection(box, tile_.window);
}

template <Arithmetic A>
bool LeafPieces<A>::in_one_plane(std::uint32_t a, std::uint32_t b, const LeafPiece& where) {
  const LeafBand apart(difference(facets_[a].depth, facets_[b].depth));
  if constexpr (A != Arithmetic::doubles)
    if (!all_corners(where, [&](const LeafCorner& c) { return !quick_sign<A>(apart, c); })) return false;
  return lines_.depth(a, b).line == nullptr;
}

template <Arithmetic A>
LeafSide LeafPieces<A>::depth(std::uint32_t near, std::uint32_t far) {
  const Facet &f = facets_[near], &g = facets_[far];
  LeafBand band(difference(f.depth, g.depth));
  band.kind = LineKind::depth;
  band.facet = near;
  band.other = far;
  // A corner that both share lies on the crossing of their planes.
  std::uint32_t points[2] = {no_id, no_id};
  int shared = 0;
  for (const std::uint32_t p : f.points)
    if (shared < 2 && (p == g.points[0] || p == g.points[1] || p == g.points[2])) points[shared++] = p;
  band.hold(points[0], points[1]);
  return add(band);
}

template <Arithmetic A>
LeafSide LeafPieces<A>::front(std::uint32_t facet) {
  LeafBand front;
  front.kind = LineKind::front;
  front.facet = facet;
  return add(front);
}

template <Arithmetic A>
Predicate LeafPieces<A>::predicate(const LeafBand& band) {
  const bool depth = band.kind == LineKind::depth || band.kind == LineKind::front;
  return depth ? Predicate::nearer_constructed : Predicate::turn_constructed;
}

template <Arithmetic A>
Side LeafPieces<A>::definition(LeafSide side) {
  const LeafBand& band = bands_[side >> 1];
  Side s;
  switch (band.kind) {
    case LineKind::edge:
      s.line = &lines_.of(band.facet).edges[band.other];
      break;
    case LineKind::depth:
      s = lines_.depth(band.facet, band.other);
      break;
    case LineKind::front:
      s = lines_.front(band.facet);
      break;
    default:
      s.line = &tile_.borders[band.facet];
  }
  return side & 1 ? -s : s;
}

template <Arithmetic A>
const Direction& LeafPieces<A>::definition_of(LeafCorner& c) {
  if (c.direction == no_id) {
    c.direction = static_cast<std::uint32_t>(directions_.size());
    directions_.push_back(cutter_.meet(definition(c.sides[0]), definition(c.sides[1])));
  }
  return directions_[c.direction];
}

template <Arithmetic A>
Cell LeafPieces<A>::definition(const LeafPiece& piece) {
  Cell cell;
  for (std::uint32_t i = piece.first; i < piece.first + piece.size; ++i) {
    cell.lines.push_back(definition(rings_[i].line));
    cell.vertices.push_back(definition_of(corners_[rings_[i].corner]));
  }
  return cell;
}

}  // namespace provis
