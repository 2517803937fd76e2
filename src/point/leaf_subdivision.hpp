#pragma once
// One subdivision for all facets of a leaf: what is visible in it has a cell, and everything else is hidden.

#include <algorithm>
#include <cmath>
#include <vector>

#include "provis/error.hpp"
#include "src/point/effects.hpp"
#include "src/point/front_to_back.hpp"
#include "src/point/leaf_pieces.hpp"

namespace provis {

/// Convex cells in window coordinates, each with all that is visible in it.
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
  struct Labelled {
    LeafPiece piece;
    boost::container::small_vector<std::uint32_t, 2> nearest;  ///< occluders, all of one plane
    boost::container::small_vector<std::uint32_t, 2> before;   ///< see-through facets no farther than those
  };
  struct Outline {  ///< of a cell, to pass most of them by
    Window box;
    double floor = -HUGE_VAL;  ///< what is nowhere as near is hidden in all of the cell
  };

  enum class Meeting { none, tied, nearer };

  void begin_anew();
  void begin(std::uint32_t facet);
  bool passes_by(const Labelled& cell);
  void replace(std::size_t cell);
  Outline outline(const Labelled& cell) const;
  Meeting meet(LeafPiece& inside, const Labelled& cell, std::uint32_t facet);
  void split(Labelled& cell, std::uint32_t facet);
  bool cut(LeafPiece& inside, LeafSide side, const Labelled& labels);

  const std::vector<Facet>& facets_;
  LeafPieces<A> pieces_;
  std::size_t inserted_ = 0;  ///< facets so far
  std::vector<Labelled> cells_, next_;
  std::vector<Outline> outlines_;  ///< of cells_
  double floor_ = -HUGE_VAL;       ///< of all cells
  CellSigns marks_;
};

template <Arithmetic A, QueryEffects E>
LeafSubdivision<A, E>::LeafSubdivision(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines,
                                       CellCutter<A>& cutter, const Tile& tile)
    : facets_(facets.facets), pieces_(signs, facets, lines, cutter, tile) {
  begin_anew();
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::begin_anew() {
  cells_.clear();
  LeafPiece& whole = cells_.emplace_back().piece;
  whole = pieces_.begin_anew();
  outlines_.assign(1, {whole.box});
  inserted_ = 0;
  floor_ = -HUGE_VAL;
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::begin(std::uint32_t facet) {
  pieces_.begin(facet);
  ++inserted_;
}

/// Whether the facet that is being inserted certainly changes nothing in the cell.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::passes_by(const Labelled& cell) {
  return (!cell.nearest.empty() && pieces_.behind(cell.nearest.front(), cell.piece)) ||
         pieces_.beside(cell.piece);
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
    if (passes_by(cells_[k])) continue;
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
  if (pieces_.beside(cell.piece)) return;
  LeafPiece inside = cell.piece;
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
    if (!overlap(f.box, outlines_[k].box) || passes_by(cells_[k])) continue;
    next_.clear();
    LeafPiece inside = cells_[k].piece;
    if (meet(inside, cells_[k], occluder) == Meeting::nearer) replace(k);
  }
  return !cells_.empty();
}

/// Narrows the cell's piece to where the facet is not farther than what is nearest there; the rest is put
/// into next_.
template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::Meeting LeafSubdivision<A, E>::meet(LeafPiece& inside, const Labelled& cell,
                                                                    std::uint32_t facet) {
  const Facet& f = facets_[facet];
  bool meets = true;
  for (std::uint32_t k = 0; k < 3 && meets; ++k) {
    if (!(f.inside[k].lowest(inside.box) > 0)) meets = cut(inside, pieces_.edge(k), cell);
  }
  if constexpr (E.front_clip)
    if (meets && f.cut) meets = cut(inside, pieces_.front(facet), cell);
  if (!meets) return Meeting::none;
  if (cell.nearest.empty()) return Meeting::nearer;
  const std::uint32_t other = cell.nearest.front();
  if (pieces_.in_one_plane(facet, other, inside)) return Meeting::tied;
  return cut(inside, pieces_.depth(facet, other), cell) ? Meeting::nearer : Meeting::none;
}

/// Leaves in next_ what becomes of the cell.
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::split(Labelled& cell, std::uint32_t facet) {
  const Facet& f = facets_[facet];
  LeafPiece inside = cell.piece;
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
bool LeafSubdivision<A, E>::cut(LeafPiece& inside, LeafSide side, const Labelled& labels) {
  const auto [positive, negative] = pieces_.classify(inside, side, marks_);
  if (!positive) return false;
  if (!negative) return true;
  next_.push_back({pieces_.part(inside, side, marks_, Sign::negative), labels.nearest, labels.before});
  inside = pieces_.part(inside, side, marks_, Sign::positive);
  return true;
}

template <Arithmetic A, QueryEffects E>
template <class Visit>
void LeafSubdivision<A, E>::for_visible(const Visit& visit) {
  for (const Labelled& cell : cells_)
    for (const auto* list : {&cell.nearest, &cell.before})
      for (const std::uint32_t f : *list) visit(f, [&] { return pieces_.definition(cell.piece); });
}

}  // namespace provis
