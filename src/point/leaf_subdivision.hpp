#pragma once
// One subdivision for all facets of a leaf: what is visible in it has a cell, and everything else is hidden.

#include <algorithm>
#include <cmath>
#include <vector>

#include "provis/error.hpp"
#include "src/point/cell_outlines.hpp"
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

  /// How many cells there are.
  std::size_t size() const { return cells_.size(); }

  /// Calls visit(facet, cell) for each facet that is seen throughout the cell, cell by cell. `cell` makes the
  /// definition of the cell when called.
  template <class Visit>
  void for_visible(const Visit& visit);

  /// Rounded signs can make cells that nothing removes: they are given up at a count that certain ones hardly
  /// ever reach.
  bool too_many() const;

 private:
  struct List {  ///< a range of listed_
    std::uint32_t first = 0, size = 0;
  };
  struct Labelled {
    LeafPiece piece;
    List nearest;  ///< occluders, all of one plane
    List before;   ///< see-through facets no farther than those
  };

  enum class Meeting { none, tied, nearer };

  void begin_anew();
  void begin(std::uint32_t facet);
  bool passes_by(const Labelled& cell);
  void replace(std::size_t cell);
  CellOutline outline(const Labelled& cell) const;
  Meeting meet(LeafPiece& inside, const Labelled& cell, std::uint32_t facet);
  void split(const Labelled& cell, std::uint32_t facet);
  bool cut(LeafPiece& inside, LeafSide side, const Labelled& labels);
  List with(List list, std::uint32_t facet);
  std::uint32_t front(List list) const { return listed_[list.first]; }

  const std::vector<Facet>& facets_;
  LeafPieces<A> pieces_;
  std::size_t inserted_ = 0;  ///< facets so far
  std::vector<Labelled> cells_, next_;
  CellOutlines outlines_;               ///< of cells_
  std::vector<std::uint32_t> touched_;  ///< by the facet that is being inserted
  double floor_ = -HUGE_VAL;            ///< of all cells
  std::vector<std::uint32_t> listed_;   ///< in the lists of all cells, those that are gone included
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
  listed_.clear();
  cells_.assign(1, {pieces_.begin_anew(), {}, {}});
  outlines_.clear();
  outlines_.push_back({cells_.front().piece.box, -HUGE_VAL});
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
  return (cell.nearest.size != 0 && pieces_.behind(front(cell.nearest), cell.piece)) ||
         pieces_.beside(cell.piece);
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::insert(const OrderedFacet& given) {
  if (given.nearest < floor_) return;
  touched_.clear();
  outlines_.append_touched(facets_[given.facet].box, given.nearest, touched_);
  if (touched_.empty()) return;
  begin(given.facet);
  bool changed = false;
  for (const std::uint32_t k : touched_) {
    if (passes_by(cells_[k])) continue;
    next_.clear();
    split(cells_[k], given.facet);
    replace(k);
    changed = true;
  }
  if (changed) floor_ = outlines_.floor();
}

/// What stands in next_ takes the place of the cell.
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::replace(std::size_t cell) {
  if (next_.empty()) {
    cells_[cell] = cells_.back();
    cells_.pop_back();
    outlines_.remove(cell);
    return;
  }
  outlines_.set(cell, outline(next_.front()));
  cells_[cell] = next_.front();
  for (std::size_t k = 1; k < next_.size(); ++k) {
    outlines_.push_back(outline(next_[k]));
    cells_.push_back(next_[k]);
  }
}

template <Arithmetic A, QueryEffects E>
CellOutline LeafSubdivision<A, E>::outline(const Labelled& cell) const {
  CellOutline o;
  o.box = cell.piece.box;
  // A bound that is not known may be NaN.
  if (cell.nearest.size != 0)
    if (const double lowest = facets_[front(cell.nearest)].depth.lowest(o.box); lowest > o.floor)
      o.floor = lowest;
  return o;
}

/// Cells are faces of an arrangement of lines: at most four of each facet, one of each two facets, and the
/// borders. That bounds how many there can be.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::too_many() const {
  const std::size_t n = inserted_, lines = 4 + 4 * n + n * n / 2;
  if constexpr (A == Arithmetic::doubles) return cells_.size() > 64 * (n + 1);
  if (cells_.size() / lines > lines)
    throw Error(Error::Code::internal, "point", "more cells than an arrangement can have faces");
  return false;
}

template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::restrict_to(std::uint32_t facet) {
  begin_anew();
  begin(facet);
  Labelled cell = cells_.front();
  cells_.clear();
  outlines_.clear();
  next_.clear();
  if (pieces_.beside(cell.piece)) return;
  LeafPiece inside = cell.piece;
  if (meet(inside, cell, facet) == Meeting::none) return;
  cell.piece = inside;
  cell.nearest = with(cell.nearest, facet);
  outlines_.push_back(outline(cell));
  cells_.push_back(cell);
}

template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::subtract(std::uint32_t occluder) {
  begin(occluder);
  touched_.clear();
  outlines_.append_touched(facets_[occluder].box, HUGE_VAL, touched_);
  // From the last to the first, for the last takes the place of one that is gone.
  for (auto it = touched_.rbegin(); it != touched_.rend(); ++it) {
    const std::uint32_t k = *it;
    if (passes_by(cells_[k])) continue;
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
  if (cell.nearest.size == 0) return Meeting::nearer;
  const std::uint32_t other = front(cell.nearest);
  if (pieces_.in_one_plane(facet, other, inside)) return Meeting::tied;
  return cut(inside, pieces_.depth(facet, other), cell) ? Meeting::nearer : Meeting::none;
}

/// Leaves in next_ what becomes of the cell.
template <Arithmetic A, QueryEffects E>
void LeafSubdivision<A, E>::split(const Labelled& cell, std::uint32_t facet) {
  const Facet& f = facets_[facet];
  LeafPiece inside = cell.piece;
  const Meeting meeting = meet(inside, cell, facet);
  if (meeting == Meeting::none) {
    // Whatever was cut off on the way here belongs to the whole again.
    next_.clear();
    next_.push_back(cell);
    return;
  }
  Labelled seen{inside, cell.nearest, cell.before};
  if (meeting == Meeting::nearer && f.occludes) seen.nearest = {};
  List& list = f.occludes ? seen.nearest : seen.before;
  list = with(list, facet);
  next_.push_back(seen);
}

/// Keeps the part where the side is positive and puts the rest aside; false if there is no such part.
template <Arithmetic A, QueryEffects E>
bool LeafSubdivision<A, E>::cut(LeafPiece& inside, LeafSide side, const Labelled& labels) {
  const auto [positive, negative] = pieces_.classify(inside, side, marks_);
  if (!positive) return false;
  if (!negative) return true;
  const auto [kept, aside] = pieces_.split(inside, side, marks_);
  next_.push_back({aside, labels.nearest, labels.before});
  inside = kept;
  return true;
}

/// Lists are values that cells share: what is added makes another one.
template <Arithmetic A, QueryEffects E>
typename LeafSubdivision<A, E>::List LeafSubdivision<A, E>::with(List list, std::uint32_t facet) {
  const List longer{static_cast<std::uint32_t>(listed_.size()), list.size + 1};
  for (std::uint32_t k = 0; k < list.size; ++k) listed_.push_back(listed_[list.first + k]);
  listed_.push_back(facet);
  return longer;
}

template <Arithmetic A, QueryEffects E>
template <class Visit>
void LeafSubdivision<A, E>::for_visible(const Visit& visit) {
  for (const Labelled& cell : cells_)
    for (const List list : {cell.nearest, cell.before})
      for (std::uint32_t k = 0; k < list.size; ++k)
        visit(listed_[list.first + k], [&] { return pieces_.definition(cell.piece); });
}

}  // namespace provis
