#pragma once
// The visibility subdivision of a rectangle, made of facets that are known to be visible, and what it hides.

#include "src/point/leaf_lines.hpp"
#include "src/point/looks.hpp"
#include "src/point/tile.hpp"

namespace provis {

/// A cell in which one occluder is nearest, or none; others of its plane may be seen with it.
struct SubdivisionPart {
  Cell cell;
  std::uint32_t nearest = no_id;
  bool missed = false;       ///< an occluder is seen in it that the aggressive method did not find
  Window box;                ///< holds the cell
  double least = -HUGE_VAL;  ///< the nearest occluder is certainly as near as this all over the cell
};

template <Arithmetic A>
class PaperSubdivision {
 public:
  PaperSubdivision(Signs<A>& signs, const Facets& facets, PartLines<A>& part, const WindowMap& map,
                   const Tile& tile)
      : signs_(signs),
        facets_(facets.facets),
        map_(map),
        window_(tile.window),
        lines_(signs, facets, part),
        cutter_(signs, part.points) {
    keep(make_cell(tile, signs.geometry().handedness), no_id, false);
  }

  LeafLines<A>& lines() { return lines_; }

  /// Inserts an occluder, by certain signs.
  void insert(std::uint32_t facet, bool missed);

  /// Calls visit(overlap, nearest) for each cell in which the facet is not strictly behind the nearest
  /// occluder everywhere, with the convex part of it where it is not. None: the facet is hidden.
  template <class Visit>
  void for_unhidden(std::uint32_t facet, const Visit& visit);

  /// The area, rounded, of the cells where the aggressive method missed what is seen.
  double area_missed() const;

 private:
  void keep(Cell cell, std::uint32_t nearest, bool missed);
  bool certainly_hidden(const Facet& f, const SubdivisionPart& part) const;
  Cell clip(Cell cell, const Region& region, std::vector<Cell>* outside);
  void place(SubdivisionPart& part, Cell overlap, std::uint32_t facet, bool missed);

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  const WindowMap& map_;
  const Window window_;
  LeafLines<A> lines_;
  CellCutter<A> cutter_;
  CellSigns scratch_;
  std::vector<SubdivisionPart> parts_;
};

template <Arithmetic A>
void PaperSubdivision<A>::keep(Cell cell, std::uint32_t nearest, bool missed) {
  boost::container::small_vector<WindowPlace, 8> places;
  for (const Direction& v : cell.vertices) places.push_back(map_.place(v.approx));
  SubdivisionPart& part = parts_.emplace_back();
  part.cell = std::move(cell);
  part.nearest = nearest;
  part.missed = missed;
  part.box = box_of({places.data(), places.size()});
  if (nearest == no_id) return;
  const double least = facets_[nearest].depth.lowest(part.box);
  if (least > part.least) part.least = least;  // not so for NaN
}

/// Beside the cell, or behind all of it: without asking for signs.
template <Arithmetic A>
bool PaperSubdivision<A>::certainly_hidden(const Facet& f, const SubdivisionPart& part) const {
  return !overlap(f.box, part.box) || separated(f, part.box) || f.depth.highest(part.box) < part.least;
}

/// The part of the cell inside the region, empty where they do not overlap; the rest of it is appended to
/// `outside` unless that is null.
template <Arithmetic A>
Cell PaperSubdivision<A>::clip(Cell cell, const Region& region, std::vector<Cell>* outside) {
  for (const Side& h : region) {
    const auto [positive, negative] = cutter_.classify(cell, h, scratch_);
    if (!positive) return {};
    if (!negative) continue;
    if (outside != nullptr) outside->push_back(cutter_.part(cell, h, scratch_, Sign::negative));
    cell = cutter_.part(cell, h, scratch_, Sign::positive);
  }
  return cell;
}

template <Arithmetic A>
void PaperSubdivision<A>::insert(std::uint32_t facet, bool missed) {
  Region cone;
  lines_.template append_cone<true>(facet, cone);
  std::vector<SubdivisionPart> before;
  before.swap(parts_);
  for (SubdivisionPart& part : before) {
    std::vector<Cell> outside;
    Cell overlap;
    if (!certainly_hidden(facets_[facet], part)) overlap = clip(part.cell, cone, &outside);
    if (overlap.empty()) {
      parts_.push_back(std::move(part));
      continue;
    }
    for (Cell& o : outside) keep(std::move(o), part.nearest, part.missed);
    place(part, std::move(overlap), facet, missed);
  }
}

/// The overlap of a cell and a facet: compares the facet with what is nearest there.
template <Arithmetic A>
void PaperSubdivision<A>::place(SubdivisionPart& part, Cell overlap, std::uint32_t facet, bool missed) {
  if (part.nearest == no_id) return keep(std::move(overlap), facet, missed);
  const Side nearer = lines_.depth(facet, part.nearest);
  if (nearer.line == nullptr) return keep(std::move(overlap), part.nearest, part.missed || missed);
  std::vector<Cell> farther;
  Cell seen = clip(overlap, {nearer}, &farther);
  if (seen.empty()) farther.assign(1, std::move(overlap));
  for (Cell& cell : farther) keep(std::move(cell), part.nearest, part.missed);
  if (!seen.empty()) keep(std::move(seen), facet, missed);
}

template <Arithmetic A>
template <class Visit>
void PaperSubdivision<A>::for_unhidden(std::uint32_t facet, const Visit& visit) {
  Region cone;
  lines_.template append_cone<true>(facet, cone);
  for (const SubdivisionPart& part : parts_) {
    if (certainly_hidden(facets_[facet], part)) continue;
    Region region;
    if (part.nearest != no_id)
      if (const Side nearer = lines_.depth(facet, part.nearest); nearer.line != nullptr)
        region.push_back(nearer);
    region.insert(region.end(), cone.begin(), cone.end());
    if (const Cell overlap = clip(part.cell, region, nullptr); !overlap.empty()) visit(overlap, part.nearest);
  }
}

template <Arithmetic A>
double PaperSubdivision<A>::area_missed() const {
  double sum = 0;
  for (const SubdivisionPart& part : parts_) {
    if (!part.missed) continue;
    double twice = 0;
    // A corner that float64 cannot tell is put back into the rectangle, where all of them are.
    const auto corner = [&](std::size_t k) {
      const Vec3d at = window_coordinates(signs_.geometry(), part.cell.vertices[k].approx.v);
      return Vec3d{std::fmin(std::fmax(at.x, window_.x0), window_.x1),
                   std::fmin(std::fmax(at.y, window_.y0), window_.y1), 0};
    };
    const Vec3d a = corner(0);
    for (std::size_t k = 2; k < part.cell.vertices.size(); ++k)
      twice += cross(corner(k - 1) - a, corner(k) - a).z;
    sum += std::fabs(twice) / 2;
  }
  return std::fmin(sum, (window_.x1 - window_.x0) * (window_.y1 - window_.y0));
}

}  // namespace provis
