#pragma once
// Convex pieces of a leaf, cut by certain signs: corners and lines are float64 with bounds, and get their
// definitions only where those cannot tell.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "src/point/leaf_lines.hpp"
#include "src/point/tile.hpp"

namespace provis {

/// Bit 0: the opposite of the line; the rest is its index.
using LeafSide = std::uint32_t;

/// Vertices are indices of corners.
struct LeafPiece : ConvexCell<LeafSide, std::uint32_t> {
  Window box;
};

/// The lines and corners of all pieces that come from one tile.
template <Arithmetic A>
class LeafPieces {
 public:
  LeafPieces(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines, CellCutter<A>& cutter,
             const Tile& tile);

  /// Forgets every line and corner but the tile's; returns the whole tile.
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
  /// Given the signs of its corners (some of both kinds).
  LeafPiece part(const LeafPiece& piece, LeafSide side, const CellSigns& signs, Sign wanted);

  Cell definition(const LeafPiece& piece);

 private:
  struct Band {  ///< a line
    WindowFunction function;
    std::uint32_t points[2] = {no_id, no_id};  ///< input points known to lie on it
    LineKind kind = LineKind::edge;
    std::uint32_t facet = 0;  ///< borders: which
    std::uint32_t other = 0;  ///< edge: which; depth: positive where `facet` is nearer than this one
  };
  struct Corner {
    double x = 0, y = 0, error = HUGE_VAL;
    LeafSide sides[2] = {0, 0};   ///< what it is the crossing of, in the order around the piece
    std::uint32_t point = no_id;  ///< input point that it is known to be
    std::uint32_t direction = no_id;
  };

  LeafSide add(const Band& band);
  Sign sign(std::uint32_t band, std::uint32_t corner);
  static std::optional<Sign> quick_sign(const WindowFunction& f, const Corner& c);
  static Predicate predicate(const Band& band);
  bool known_zero(const Band& band, const Corner& corner) const;
  bool one_line(const Band& a, const Band& b) const;
  std::uint32_t crossing(LeafSide l, LeafSide m);
  void place(Corner& corner) const;
  Window box_of(const LeafPiece& piece) const;
  Side definition(LeafSide side);
  const Direction& definition_of(std::uint32_t corner);

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  LeafLines<A>& lines_;
  CellCutter<A>& cutter_;
  const Tile& tile_;
  std::vector<Band> bands_;
  std::uint32_t facet_ = 0;
  std::uint32_t edges_ = no_id;  ///< its edges, which most facets never need
  std::vector<Corner> corners_;
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
    Band band;
    band.function = borders[k];
    // The value of a border's function is rounded twice, of numbers no larger than these.
    const double size = std::fabs(w.x0) + std::fabs(w.x1) + std::fabs(w.y0) + std::fabs(w.y1);
    band.function.error = evaluation_error(size) + underflow_bound;
    band.kind = k % 2 == 0 ? LineKind::x_border : LineKind::y_border;
    band.facet = k;
    add(band);
  }
  const bool positive = signs.geometry().handedness == Sign::positive;
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t border = positive ? k : (4 - k) % 4, at = positive ? k : 3 - k;
    const std::uint32_t following = positive ? (k + 1) % 4 : 3 - k;
    Corner corner;
    corner.x = xs[at];
    corner.y = ys[at];
    corner.error = 0;
    corner.sides[0] = 2 * border;
    corner.sides[1] = 2 * following;
    corner.direction = k;
    directions_.push_back(tile.corners[at]);
    corners_.push_back(corner);
  }
}

template <Arithmetic A>
LeafPiece LeafPieces<A>::begin_anew() {
  bands_.resize(4);
  corners_.resize(4);
  directions_.resize(4);
  LeafPiece whole;
  for (std::uint32_t k = 0; k < 4; ++k) {
    whole.lines.push_back(corners_[k].sides[0]);
    whole.vertices.push_back(k);
  }
  whole.box = tile_.window;
  return whole;
}

template <Arithmetic A>
LeafSide LeafPieces<A>::add(const Band& band) {
  bands_.push_back(band);
  return static_cast<LeafSide>(2 * (bands_.size() - 1));
}

template <Arithmetic A>
void LeafPieces<A>::begin(std::uint32_t facet) {
  facet_ = facet;
  edges_ = no_id;
}

template <Arithmetic A>
LeafSide LeafPieces<A>::edge(std::uint32_t k) {
  if (edges_ == no_id) {
    const Facet& f = facets_[facet_];
    edges_ = static_cast<std::uint32_t>(bands_.size());
    for (std::uint32_t i = 0; i < 3; ++i) {
      Band& band = bands_.emplace_back();
      band.function = f.inside[i];
      band.facet = facet_;
      band.other = i;
      band.points[0] = f.points[i];
      band.points[1] = f.points[(i + 1) % 3];
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
    const Band& band = bands_[edge(k) >> 1];
    if (std::all_of(piece.vertices.begin(), piece.vertices.end(), [&](std::uint32_t c) {
          return known_zero(band, corners_[c]) || quick_sign(band.function, corners_[c]) == Sign::negative;
        }))
      return true;
  }
  return false;
}

template <Arithmetic A>
bool LeafPieces<A>::behind(std::uint32_t other, const LeafPiece& piece) const {
  const Facet& f = facets_[facet_];
  if (!overlap(piece.box, f.box)) return false;
  const WindowFunction farther = difference(facets_[other].depth, f.depth);
  if (farther.lowest(intersection(piece.box, f.box)) > 0) return true;
  const double slope = std::fabs(farther.a) + std::fabs(farther.b);
  return std::all_of(piece.vertices.begin(), piece.vertices.end(), [&](std::uint32_t k) {
    const Corner& c = corners_[k];
    return farther.at(c.x, c.y) > (3 * farther.error + slope * c.error) * (1 + 0x1p-20);
  });
}

template <Arithmetic A>
std::pair<bool, bool> LeafPieces<A>::classify(const LeafPiece& piece, LeafSide side, CellSigns& marks) {
  marks.clear();
  bool positive = false, negative = false;
  for (const std::uint32_t c : piece.vertices) {
    const Sign of_line = sign(side >> 1, c), s = side & 1 ? -of_line : of_line;
    marks.push_back(s);
    positive |= s == Sign::positive;
    negative |= s == Sign::negative;
  }
  return {positive, negative};
}

/// Of the line, not of its opposite.
template <Arithmetic A>
Sign LeafPieces<A>::sign(std::uint32_t band, std::uint32_t corner) {
  const Corner& c = corners_[corner];
  if (known_zero(bands_[band], c)) {
    signs_.count(predicate(bands_[band]), Tier::structure);
    return Sign::zero;
  }
  if (const std::optional<Sign> s = quick_sign(bands_[band].function, c)) {
    signs_.count(predicate(bands_[band]), Tier::filter);
    if constexpr (A == Arithmetic::doubles)
      if (signs_.geometry().checked) [[unlikely]] {
        const Side side = definition(2 * band);
        signs_.check(*side.line, definition_of(corner), side.negated ? -*s : *s);
      }
    return *s;
  }
  const Side side = definition(2 * band);
  const Sign s = signs_.side(*side.line, definition_of(corner));
  return side.negated ? -s : s;
}

/// Where float64 can tell; plain doubles always can, but for what is not known at all.
template <Arithmetic A>
std::optional<Sign> LeafPieces<A>::quick_sign(const WindowFunction& f, const Corner& c) {
  const double value = f.at(c.x, c.y);
  // Where the corner is off, the value is by no more than the slope (ERRORS.md, 6).
  const double bound = (3 * f.error + (std::fabs(f.a) + std::fabs(f.b)) * c.error) * (1 + 0x1p-20);
  if constexpr (A == Arithmetic::doubles)
    return bound < HUGE_VAL ? std::optional(sign_of(value)) : std::nullopt;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return std::nullopt;
}

template <Arithmetic A>
bool LeafPieces<A>::one_line(const Band& a, const Band& b) const {
  return &a == &b || (a.points[1] != no_id && b.points[1] != no_id &&
                      ((a.points[0] == b.points[0] && a.points[1] == b.points[1]) ||
                       (a.points[0] == b.points[1] && a.points[1] == b.points[0])));
}

template <Arithmetic A>
bool LeafPieces<A>::known_zero(const Band& band, const Corner& c) const {
  return (c.point != no_id && (c.point == band.points[0] || c.point == band.points[1])) ||
         one_line(band, bands_[c.sides[0] >> 1]) || one_line(band, bands_[c.sides[1] >> 1]);
}

template <Arithmetic A>
LeafPiece LeafPieces<A>::part(const LeafPiece& piece, LeafSide side, const CellSigns& s, Sign wanted) {
  LeafPiece out;
  cut_out(
      piece, wanted == Sign::positive ? side : side ^ 1, s, wanted,
      [&](LeafSide l, LeafSide m) { return crossing(l, m); }, out);
  out.box = box_of(out);
  return out;
}

template <Arithmetic A>
std::uint32_t LeafPieces<A>::crossing(LeafSide l, LeafSide m) {
  Corner c;
  c.sides[0] = l;
  c.sides[1] = m;
  const Band &a = bands_[l >> 1], &b = bands_[m >> 1];
  for (const std::uint32_t p : a.points)
    if (p != no_id && (p == b.points[0] || p == b.points[1])) c.point = p;
  place(c);
  corners_.push_back(c);
  return static_cast<std::uint32_t>(corners_.size() - 1);
}

/// Where two lines cross inside the tile (ERRORS.md, 6).
template <Arithmetic A>
void LeafPieces<A>::place(Corner& c) const {
  const WindowFunction &f = bands_[c.sides[0] >> 1].function, &g = bands_[c.sides[1] >> 1].function;
  const Window& w = tile_.window;
  const double determinant = f.a * g.b - g.a * f.b;
  c.x = std::clamp((f.b * g.c - g.b * f.c) / determinant, w.x0, w.x1);
  c.y = std::clamp((g.a * f.c - f.a * g.c) / determinant, w.y0, w.y1);
  const double off_f = std::fabs(f.at(c.x, c.y)) + 2 * f.error,
               off_g = std::fabs(g.at(c.x, c.y)) + 2 * g.error;
  const double least =
      std::fabs(determinant) - 8 * unit_roundoff * (std::fabs(f.a * g.b) + std::fabs(g.a * f.b));
  const double reach =
      std::max(std::fabs(f.a), std::fabs(f.b)) * off_g + std::max(std::fabs(g.a), std::fabs(g.b)) * off_f;
  const double error = reach / least * (1 + 0x1p-20) + underflow_bound;
  if (least > 0x1p-900 && error < size_bound) {
    c.error = error;
    return;
  }
  c.x = w.x0;
  c.y = w.y0;
}

/// Corners lie in the tile.
template <Arithmetic A>
Window LeafPieces<A>::box_of(const LeafPiece& piece) const {
  Window box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const std::uint32_t k : piece.vertices) {
    const Corner& c = corners_[k];
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
  const WindowFunction apart = difference(facets_[a].depth, facets_[b].depth);
  if constexpr (A != Arithmetic::doubles)
    if (std::any_of(where.vertices.begin(), where.vertices.end(),
                    [&](std::uint32_t k) { return quick_sign(apart, corners_[k]).has_value(); }))
      return false;
  return lines_.depth(a, b).line == nullptr;
}

template <Arithmetic A>
LeafSide LeafPieces<A>::depth(std::uint32_t near, std::uint32_t far) {
  const Facet &f = facets_[near], &g = facets_[far];
  Band band;
  band.function = difference(f.depth, g.depth);
  band.kind = LineKind::depth;
  band.facet = near;
  band.other = far;
  // A corner that both share lies on the crossing of their planes.
  int shared = 0;
  for (const std::uint32_t p : f.points)
    if (shared < 2 && (p == g.points[0] || p == g.points[1] || p == g.points[2])) band.points[shared++] = p;
  return add(band);
}

template <Arithmetic A>
LeafSide LeafPieces<A>::front(std::uint32_t facet) {
  Band front;
  front.kind = LineKind::front;
  front.facet = facet;
  return add(front);
}

template <Arithmetic A>
Predicate LeafPieces<A>::predicate(const Band& band) {
  const bool depth = band.kind == LineKind::depth || band.kind == LineKind::front;
  return depth ? Predicate::nearer_constructed : Predicate::turn_constructed;
}

template <Arithmetic A>
Side LeafPieces<A>::definition(LeafSide side) {
  const Band& band = bands_[side >> 1];
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
const Direction& LeafPieces<A>::definition_of(std::uint32_t corner) {
  Corner& c = corners_[corner];
  if (c.direction == no_id) {
    c.direction = static_cast<std::uint32_t>(directions_.size());
    directions_.push_back(cutter_.meet(definition(c.sides[0]), definition(c.sides[1])));
  }
  return directions_[c.direction];
}

template <Arithmetic A>
Cell LeafPieces<A>::definition(const LeafPiece& piece) {
  Cell cell;
  for (const LeafSide s : piece.lines) cell.lines.push_back(definition(s));
  for (const std::uint32_t c : piece.vertices) cell.vertices.push_back(definition_of(c));
  return cell;
}

}  // namespace provis
