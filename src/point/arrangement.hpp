#pragma once
// The planar subdivision inside one tile: convex cells, each with everything that is visible there.

#include <vector>

#include "provis/error.hpp"
#include "src/point/area.hpp"
#include "src/point/leaf.hpp"

namespace provis {

/// A cell and what is seen in it; the nearest occluders lie in one plane.
struct LabelledCell {
  Cell cell;
  std::vector<std::uint32_t> nearest;  ///< occluding facets, all of one plane
  std::vector<std::uint32_t> before;   ///< see-through facets no farther than those
};

/// Inserts one facet after another, occluders first. Every branch is a certain sign, and the areas of the
/// cells are held against the tile's.
template <Arithmetic A, QueryEffects E>
class Arrangement {
 public:
  Arrangement(Signs<A>& signs, const Facets& facets, PartLines<A>& lines, const Tile& tile,
              const std::vector<std::uint32_t>& members)
      : signs_(signs), facets_(facets.facets), tile_(tile), leaf_(signs, facets, lines, tile, members) {
    cells_.push_back({make_cell(tile, signs.geometry().handedness), {}, {}});
    for (const std::uint32_t f : members)
      if (facets_[f].occludes) insert(f);
    for (const std::uint32_t f : members)
      if (!facets_[f].occludes) insert(f);
  }

  /// Appends the cells with their exact areas.
  void report(int frame, std::vector<SubdivisionCell>& out) const;

 private:
  void insert(std::uint32_t f);
  void place(LabelledCell inside, std::uint32_t f, std::vector<LabelledCell>& out);
  void label(LabelledCell& cell, std::uint32_t f) const;

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  const Tile& tile_;
  Leaf<A, E> leaf_;
  std::vector<LabelledCell> cells_;
};

template <Arithmetic A, QueryEffects E>
void Arrangement<A, E>::insert(std::uint32_t f) {
  Region cone;
  leaf_.lines().template append_cone<E.front_clip>(f, cone);
  std::vector<LabelledCell> next;
  std::vector<Cell> outside;
  for (LabelledCell& c : cells_) {
    outside.clear();
    Cell inside = leaf_.cut(c.cell, cone, outside);
    for (Cell& o : outside) next.push_back({std::move(o), c.nearest, c.before});
    if (!inside.empty()) place({std::move(inside), std::move(c.nearest), std::move(c.before)}, f, next);
  }
  cells_ = std::move(next);
}

/// A cell in which facet f has hits everywhere: compares f with what is nearest there.
template <Arithmetic A, QueryEffects E>
void Arrangement<A, E>::place(LabelledCell c, std::uint32_t f, std::vector<LabelledCell>& out) {
  const Side nearer = c.nearest.empty() ? Side{} : leaf_.lines().depth(f, c.nearest.front());
  if (nearer.line == nullptr) {
    label(c, f);
    out.push_back(std::move(c));
    return;
  }
  std::vector<Cell> farther;
  Cell seen = leaf_.cut(c.cell, {nearer}, farther);
  for (Cell& cell : farther) out.push_back({std::move(cell), c.nearest, c.before});
  if (seen.empty()) return;
  LabelledCell front{std::move(seen), c.nearest, c.before};
  if (facets_[f].occludes) front.nearest.clear();
  label(front, f);
  out.push_back(std::move(front));
}

template <Arithmetic A, QueryEffects E>
void Arrangement<A, E>::label(LabelledCell& cell, std::uint32_t f) const {
  (facets_[f].occludes ? cell.nearest : cell.before).push_back(f);
}

template <Arithmetic A, QueryEffects E>
void Arrangement<A, E>::report(int frame, std::vector<SubdivisionCell>& out) const {
  const Window& w = tile_.window;
  AreaBalance balance;
  for (const LabelledCell& c : cells_) {
    const std::vector<WindowPoint> polygon = window_polygon(signs_.geometry(), c.cell);
    const Rational size = area(polygon);
    balance.add(size);
    SubdivisionCell& cell = out.emplace_back();
    cell.frame = frame;
    for (const WindowPoint& p : polygon) cell.corners.push_back(rounded(p));
    std::ostringstream text;
    text << size;
    cell.area = text.str();
    cell.area_rounded = CGAL::to_double(size);
    for (const auto* list : {&c.nearest, &c.before})
      for (const std::uint32_t f : *list) cell.visible.push_back(facets_[f].id);
    std::sort(cell.visible.begin(), cell.visible.end());
  }
  if constexpr (A != Arithmetic::doubles)
    if (!balance.equals((Rational(w.x1) - Rational(w.x0)) * (Rational(w.y1) - Rational(w.y0))))
      throw Error(Error::Code::internal, "subdivision", "the areas of the cells do not sum to the tile's");
}

}  // namespace provis
