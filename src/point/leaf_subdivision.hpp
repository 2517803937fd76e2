#pragma once
// One subdivision for all facets of a leaf: what is visible in it has a cell, and everything else is hidden.

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "provis/error.hpp"
#include "src/point/effects.hpp"
#include "src/point/front_to_back.hpp"
#include "src/point/leaf_lines.hpp"
#include "src/point/tile.hpp"

namespace provis {

/// Convex cells in window coordinates, each with all that is visible in it. Cells are cut by certain signs;
/// corners and lines are float64 with bounds, and get their definitions only where those cannot tell.
template <Arithmetic A, QueryEffects E>
class LeafSubdivision {
 public:
  /// The tile as one cell of background.
  LeafSubdivision(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines, CellCutter<A>& cutter,
                  const Tile& tile);

  /// In any order; the nearest first makes the fewest cells. Occluders before see-through facets.
  void insert(const OrderedFacet& facet);

  /// Begins anew, and keeps only what is in the facet's cone. From then on the other occluders are not
  /// inserted but subtracted.
  void restrict_to(std::uint32_t facet);

  /// Takes away where the occluder is strictly nearer than the facet that the cells are restricted to; false
  /// if nothing is left.
  bool subtract(std::uint32_t occluder);

  /// Calls visit(facet, cell) for each facet that is seen throughout the cell, cell by cell. `cell` makes the
  /// definition of the cell when called.
  template <class Visit>
  void for_visible(const Visit& visit);

  /// Rounded signs can make cells that nothing removes: they are given up at a count that certain ones hardly
  /// ever reach.
  bool too_many() const;

 private:
  /// Bit 0: the opposite of the line; the rest is its index.
  using SideOf = std::uint32_t;
  template <class T>
  using Few = boost::container::small_vector<T, 8>;

  struct Band {  ///< a line
    WindowFunction function;
    std::uint32_t points[2] = {no_id, no_id};  ///< input points known to lie on it
    LineKind kind = LineKind::edge;
    std::uint32_t facet = 0;  ///< borders: which
    std::uint32_t other = 0;  ///< edge: which; depth: positive where `facet` is nearer than this one
  };
  struct Corner {
    double x = 0, y = 0, error = HUGE_VAL;
    SideOf sides[2] = {0, 0};     ///< what it is the crossing of, in the order around the cell
    std::uint32_t point = no_id;  ///< input point that it is known to be
    std::uint32_t direction = no_id;
  };
  struct Piece {
    Few<SideOf> sides;
    Few<std::uint32_t> corners;  ///< corner k is where side k meets side k + 1
    Window box;

    bool empty() const { return sides.size() < 3; }
  };
  struct Labelled {
    Piece piece;
    boost::container::small_vector<std::uint32_t, 2> nearest;  ///< occluders, all of one plane
    boost::container::small_vector<std::uint32_t, 2> before;   ///< see-through facets no farther than those
  };
  struct Outline {  ///< of a cell, to pass most of them by
    Window box;
    double floor = -HUGE_VAL;  ///< what is nowhere as near is hidden in all of the cell
  };
  using Marks = boost::container::small_vector<Sign, 12>;

  bool beside(const Facet& f, const Piece& piece);
  bool behind(const Facet& f, const Labelled& cell) const;
  void begin_anew();
  void begin(std::uint32_t facet);
  std::uint32_t edge(std::uint32_t k);
  void replace(std::size_t cell);
  Outline outline(const Labelled& cell) const;
  enum class Meeting { none, tied, nearer };
  Meeting meet(Piece& inside, const Labelled& cell, std::uint32_t facet);
  void split(Labelled& cell, std::uint32_t facet);
  bool cut(Piece& inside, SideOf side, const Labelled& labels);
  void keep(Piece piece, const Labelled& labels);
  Piece part(const Piece& piece, SideOf side, const Marks& marks, Sign wanted);
  std::pair<bool, bool> classify(const Piece& piece, SideOf side, Marks& marks);
  Sign sign(std::uint32_t band, std::uint32_t corner);
  static std::optional<Sign> quick_sign(const WindowFunction& f, const Corner& c);
  static Predicate predicate(const Band& band);
  bool known_zero(const Band& band, const Corner& corner) const;
  bool one_line(const Band& a, const Band& b) const;
  std::uint32_t crossing(SideOf l, SideOf m);
  void place(Corner& corner) const;
  Window box_of(const Piece& piece) const;
  bool in_one_plane(std::uint32_t a, std::uint32_t b, const Piece& where);
  Band depth(std::uint32_t near, std::uint32_t far) const;
  SideOf add(const Band& band);

  Side definition(SideOf side);
  const Direction& definition_of(std::uint32_t corner);
  Cell definition(const Piece& piece);

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  LeafLines<A>& lines_;
  CellCutter<A>& cutter_;
  const Tile& tile_;
  std::vector<Band> bands_;
  std::size_t inserted_ = 0;     ///< facets so far
  std::uint32_t facet_ = 0;      ///< the last of them
  std::uint32_t edges_ = no_id;  ///< its edges, which most facets never need
  std::vector<Corner> corners_;
  std::vector<Direction> directions_;
  std::vector<Labelled> cells_, next_;
  std::vector<Outline> outlines_;  ///< of cells_
  double floor_ = -HUGE_VAL;       ///< of all cells
  Marks marks_;
};

template <Arithmetic A, QueryEffects E>
LeafSubdivision<A, E>::LeafSubdivision(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines,
                                       CellCutter<A>& cutter, const Tile& tile)
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
  begin_anew();
}

/// Borders and corners of the tile stay.
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::begin_anew() {
  bands_.resize(4);
  corners_.resize(4);
  directions_.resize(4);
  cells_.clear();
  Piece& whole = cells_.emplace_back().piece;
  for (std::uint32_t k = 0; k < 4; ++k) {
    whole.sides.push_back(corners_[k].sides[0]);
    whole.corners.push_back(k);
  }
  whole.box = tile_.window;
  outlines_.assign(1, {tile_.window});
  inserted_ = 0;
  floor_ = -HUGE_VAL;
}

template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::SideOf LeafSubdivision<A, E>::add(const Band& band) {
  bands_.push_back(band);
  return static_cast<SideOf>(2 * (bands_.size() - 1));
}

/// Whether the facet certainly has nothing in the piece but contact.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::beside(const Facet& f, const Piece& piece) {
  if (!overlap(f.box, piece.box)) return true;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (f.inside[k].highest(piece.box) < 0) return true;
    if (f.inside[k].lowest(piece.box) > 0) continue;
    const Band& band = bands_[edge(k)];
    if (std::all_of(piece.corners.begin(), piece.corners.end(), [&](std::uint32_t c) {
          return known_zero(band, corners_[c]) || quick_sign(band.function, corners_[c]) == Sign::negative;
        }))
      return true;
  }
  return false;
}

/// Whether the facet is certainly behind the nearest occluder all over the cell.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::behind(const Facet& f, const Labelled& cell) const {
  if (cell.nearest.empty() || !overlap(cell.piece.box, f.box)) return false;
  const WindowFunction farther = difference(facets_[cell.nearest.front()].depth, f.depth);
  if (farther.lowest(intersection(cell.piece.box, f.box)) > 0) return true;
  const double slope = std::fabs(farther.a) + std::fabs(farther.b);
  return std::all_of(cell.piece.corners.begin(), cell.piece.corners.end(), [&](std::uint32_t k) {
    const Corner& c = corners_[k];
    return farther.at(c.x, c.y) > (3 * farther.error + slope * c.error) * (1 + 0x1p-20);
  });
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::begin(std::uint32_t facet) {
  facet_ = facet;
  edges_ = no_id;
  ++inserted_;
}

/// The band of one edge of the facet that is being inserted.
template <Arithmetic A, QueryEffects E>
std::uint32_t LeafSubdivision<A, E>::edge(std::uint32_t k) {
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
  return edges_ + k;
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::insert(const OrderedFacet& given) {
  if (given.nearest < floor_) return;
  const Facet& f = facets_[given.facet];
  begin(given.facet);
  const std::size_t before = cells_.size();
  bool changed = false;
  for (std::size_t k = 0; k < before; ++k) {
    if (given.nearest < outlines_[k].floor || !overlap(f.box, outlines_[k].box)) continue;
    if (behind(f, cells_[k]) || beside(f, cells_[k].piece)) continue;
    Labelled cell = std::move(cells_[k]);
    next_.clear();
    split(cell, given.facet);
    replace(k);
    changed = true;
  }
  if (!changed) return;
  floor_ = HUGE_VAL;
  for (const Outline& o : outlines_) floor_ = std::min(floor_, o.floor);
}

/// What stands in next_ takes the place of the cell.
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::replace(std::size_t cell) {
  if (next_.empty()) {
    cells_[cell] = std::move(cells_.back());
    outlines_[cell] = outlines_.back();
    cells_.pop_back();
    outlines_.pop_back();
    return;
  }
  outlines_[cell] = outline(next_.front());
  cells_[cell] = std::move(next_.front());
  for (std::size_t k = 1; k < next_.size(); ++k) {
    outlines_.push_back(outline(next_[k]));
    cells_.push_back(std::move(next_[k]));
  }
}

template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::Outline LeafSubdivision<A, E>::outline(const Labelled& cell) const {
  Outline o;
  o.box = cell.piece.box;
  // A bound that is not known may be NaN.
  if (!cell.nearest.empty())
    if (const double lowest = facets_[cell.nearest.front()].depth.lowest(o.box); lowest > o.floor)
      o.floor = lowest;
  return o;
}

/// Cells are faces of an arrangement of lines: at most four of each facet, one of each two facets, and the
/// borders. That bounds how many there can be.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::too_many() const {
  const std::size_t n = inserted_, lines = 4 + 4 * n + n * n / 2;
  if constexpr (A == Arithmetic::doubles) return cells_.size() > 64 * (n + 1);
  if (cells_.size() > lines * lines)
    throw Error(Error::Code::internal, "point", "more cells than an arrangement can have faces");
  return false;
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::restrict_to(std::uint32_t facet) {
  begin_anew();
  begin(facet);
  Labelled cell = std::move(cells_.front());
  cells_.clear();
  outlines_.clear();
  next_.clear();
  if (beside(facets_[facet], cell.piece)) return;
  Piece inside = cell.piece;
  if (meet(inside, cell, facet) == Meeting::none) return;
  cell.piece = std::move(inside);
  cell.nearest.push_back(facet);
  outlines_.push_back(outline(cell));
  cells_.push_back(std::move(cell));
}

template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::subtract(std::uint32_t occluder) {
  const Facet& f = facets_[occluder];
  begin(occluder);
  const std::size_t before = cells_.size();
  for (std::size_t k = before; k-- > 0;) {
    if (!overlap(f.box, outlines_[k].box) || behind(f, cells_[k]) || beside(f, cells_[k].piece)) continue;
    next_.clear();
    Piece inside = cells_[k].piece;
    if (meet(inside, cells_[k], occluder) == Meeting::nearer) replace(k);
  }
  return !cells_.empty();
}

/// Narrows the cell's piece to where the facet is not farther than what is nearest there; the rest is put
/// into next_.
template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::Meeting LeafSubdivision<A, E>::meet(Piece& inside, const Labelled& cell,
                                                                    std::uint32_t facet) {
  const Facet& f = facets_[facet];
  bool meets = true;
  for (std::uint32_t k = 0; k < 3 && meets; ++k) {
    if (!(f.inside[k].lowest(inside.box) > 0)) meets = cut(inside, 2 * edge(k), cell);
  }
  if constexpr (E.front_clip)
    if (meets && f.cut) {
      Band front;
      front.kind = LineKind::front;
      front.facet = facet;
      meets = cut(inside, add(front), cell);
    }
  if (!meets) return Meeting::none;
  if (cell.nearest.empty()) return Meeting::nearer;
  const std::uint32_t other = cell.nearest.front();
  if (in_one_plane(facet, other, inside)) return Meeting::tied;
  return cut(inside, add(depth(facet, other)), cell) ? Meeting::nearer : Meeting::none;
}

/// Leaves in next_ what becomes of the cell.
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::split(Labelled& cell, std::uint32_t facet) {
  const Facet& f = facets_[facet];
  Piece inside = cell.piece;
  const Meeting meeting = meet(inside, cell, facet);
  if (meeting == Meeting::none) {
    // Whatever was cut off on the way here belongs to the whole again.
    next_.clear();
    next_.push_back(std::move(cell));
    return;
  }
  Labelled seen{std::move(inside), cell.nearest, cell.before};
  if (meeting == Meeting::nearer && f.occludes) seen.nearest.clear();
  (f.occludes ? seen.nearest : seen.before).push_back(facet);
  next_.push_back(std::move(seen));
}

/// Keeps the part where the side is positive and puts the rest aside; false if there is no such part.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::cut(Piece& inside, SideOf side, const Labelled& labels) {
  const auto [positive, negative] = classify(inside, side, marks_);
  if (!positive) return false;
  if (!negative) return true;
  keep(part(inside, side, marks_, Sign::negative), labels);
  inside = part(inside, side, marks_, Sign::positive);
  return true;
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::keep(Piece piece, const Labelled& labels) {
  next_.push_back({std::move(piece), labels.nearest, labels.before});
}

/// As CellCutter::part.
template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::Piece LeafSubdivision<A, E>::part(const Piece& piece, SideOf side,
                                                                  const Marks& s, Sign wanted) {
  const std::size_t n = piece.sides.size();
  const auto stays = [&](std::size_t k) { return s[(k + n - 1) % n] == wanted || s[k] == wanted; };
  const SideOf border = wanted == Sign::positive ? side : side ^ 1;
  Piece out;
  for (std::size_t k = 0; k < n; ++k) {
    if (!stays(k)) continue;
    const std::size_t next = (k + 1) % n;
    out.sides.push_back(piece.sides[k]);
    if (stays(next) && s[k] == wanted) {
      out.corners.push_back(piece.corners[k]);
      continue;
    }
    std::size_t back = next;
    while (!stays(back)) back = (back + 1) % n;
    const std::size_t before_back = (back + n - 1) % n;
    out.corners.push_back(s[k] == Sign::zero ? piece.corners[k] : crossing(piece.sides[k], border));
    out.sides.push_back(border);
    out.corners.push_back(s[before_back] == Sign::zero ? piece.corners[before_back]
                                                       : crossing(border, piece.sides[back]));
  }
  out.box = box_of(out);
  return out;
}

template <Arithmetic A, QueryEffects E>
std::pair<bool, bool> LeafSubdivision<A, E>::classify(const Piece& piece, SideOf side, Marks& marks) {
  marks.clear();
  bool positive = false, negative = false;
  for (const std::uint32_t c : piece.corners) {
    const Sign of_line = sign(side >> 1, c), s = side & 1 ? -of_line : of_line;
    marks.push_back(s);
    positive |= s == Sign::positive;
    negative |= s == Sign::negative;
  }
  return {positive, negative};
}

/// Of the line, not of its opposite.
template <Arithmetic A, QueryEffects E>
Sign LeafSubdivision<A, E>::sign(std::uint32_t band, std::uint32_t corner) {
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
template <Arithmetic A, QueryEffects E>
std::optional<Sign> LeafSubdivision<A, E>::quick_sign(const WindowFunction& f, const Corner& c) {
  const double value = f.at(c.x, c.y);
  // Where the corner is off, the value is by no more than the slope (ERRORS.md, 6).
  const double bound = (3 * f.error + (std::fabs(f.a) + std::fabs(f.b)) * c.error) * (1 + 0x1p-20);
  if constexpr (A == Arithmetic::doubles)
    return bound < HUGE_VAL ? std::optional(sign_of(value)) : std::nullopt;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return std::nullopt;
}

template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::one_line(const Band& a, const Band& b) const {
  return &a == &b || (a.points[1] != no_id && b.points[1] != no_id &&
                      ((a.points[0] == b.points[0] && a.points[1] == b.points[1]) ||
                       (a.points[0] == b.points[1] && a.points[1] == b.points[0])));
}

template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::known_zero(const Band& band, const Corner& c) const {
  return (c.point != no_id && (c.point == band.points[0] || c.point == band.points[1])) ||
         one_line(band, bands_[c.sides[0] >> 1]) || one_line(band, bands_[c.sides[1] >> 1]);
}

template <Arithmetic A, QueryEffects E>
std::uint32_t LeafSubdivision<A, E>::crossing(SideOf l, SideOf m) {
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
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::place(Corner& c) const {
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
template <Arithmetic A, QueryEffects E>
Window LeafSubdivision<A, E>::box_of(const Piece& piece) const {
  Window box{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (const std::uint32_t k : piece.corners) {
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

template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::in_one_plane(std::uint32_t a, std::uint32_t b, const Piece& where) {
  const WindowFunction apart = difference(facets_[a].depth, facets_[b].depth);
  if constexpr (A != Arithmetic::doubles)
    if (std::any_of(where.corners.begin(), where.corners.end(),
                    [&](std::uint32_t k) { return quick_sign(apart, corners_[k]).has_value(); }))
      return false;
  return lines_.depth(a, b).line == nullptr;
}

/// Positive where the first is strictly nearer. Requires: not in one plane.
template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::Band LeafSubdivision<A, E>::depth(std::uint32_t near,
                                                                  std::uint32_t far) const {
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
  return band;
}

template <Arithmetic A, QueryEffects E>
Predicate LeafSubdivision<A, E>::predicate(const Band& band) {
  const bool depth = band.kind == LineKind::depth || band.kind == LineKind::front;
  return depth ? Predicate::nearer_constructed : Predicate::turn_constructed;
}

template <Arithmetic A, QueryEffects E>
Side LeafSubdivision<A, E>::definition(SideOf side) {
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

template <Arithmetic A, QueryEffects E>
const Direction& LeafSubdivision<A, E>::definition_of(std::uint32_t corner) {
  Corner& c = corners_[corner];
  if (c.direction == no_id) {
    c.direction = static_cast<std::uint32_t>(directions_.size());
    directions_.push_back(cutter_.meet(definition(c.sides[0]), definition(c.sides[1])));
  }
  return directions_[c.direction];
}

template <Arithmetic A, QueryEffects E>
Cell LeafSubdivision<A, E>::definition(const Piece& piece) {
  Cell cell;
  for (const SideOf s : piece.sides) cell.lines.push_back(definition(s));
  for (const std::uint32_t c : piece.corners) cell.vertices.push_back(definition_of(c));
  return cell;
}

template <Arithmetic A, QueryEffects E>
template <class Visit>
void LeafSubdivision<A, E>::for_visible(const Visit& visit) {
  for (const Labelled& cell : cells_)
    for (const auto* list : {&cell.nearest, &cell.before})
      for (const std::uint32_t f : *list) visit(f, [&] { return definition(cell.piece); });
}

}  // namespace provis
