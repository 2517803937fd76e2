#pragma once
// Deciding, in one small rectangle, which facets are visible there: certified samples first, and exact
// subtraction of what the samples met.

#include <algorithm>
#include <cmath>
#include <vector>

#include "provis/error.hpp"
#include "src/point/effects.hpp"
#include "src/point/leaf_lines.hpp"
#include "src/point/tile.hpp"
#include "src/point/witness_point.hpp"

namespace provis {

/// How a facet was found visible: by one certain sample, or because nothing was left to subtract.
struct Sight {
  bool visible = false;
  bool sampled = false;
  Direction sample;  ///< where sampled: a window ray on which the facet is certainly seen
  Cell cell;         ///< a cell of the image in which it is seen somewhere; everywhere if not sampled
};

template <Arithmetic A, QueryEffects E>
class Leaf {
 public:
  using FacetType = Facet<typename HotNumber<A>::type>;

  /// members: indices of every facet that may have hits in the tile.
  Leaf(Signs<A>& signs, const Facets<A>& facets, const Tile& tile, const std::vector<std::uint32_t>& members)
      : signs_(signs),
        facets_(facets.facets),
        tile_(tile),
        members_(members),
        lines_(signs, facets.facets),
        cutter_(signs, facets.points) {}

  /// Whether facet t is visible within the tile.
  Sight look(std::uint32_t t);

  /// A ray on which facet t is hit strictly inside, and which meets no other occluder up to there, not even
  /// at the hit (R11). Requires: sight is what look(t) gave.
  WitnessPoint witness(std::uint32_t t, const Sight& sight);

  LeafLines<A>& lines() { return lines_; }

  /// Cuts the region out of the cell: appends what remains to `outside`, returns the part inside (empty if
  /// the two do not overlap; then the whole cell remains).
  Cell cut(const Cell& cell, const Region& region, std::vector<Cell>& outside);

 private:
  enum class Meeting { clear, blocked };

  bool sample_in(const Cell& cell, Direction& sample) const;
  Meeting meet(std::uint32_t o, std::uint32_t t, const Direction& sample);
  bool misses(std::uint32_t o, std::uint32_t t, const Vec3<ExactNumber>& ray);
  template <class Clear>
  bool clear_of_all(std::uint32_t t, const Clear& clear) const;
  void subtract(std::uint32_t o, std::uint32_t t, std::vector<Cell>& pieces);
  bool too_many(std::size_t pieces) const;

  Signs<A>& signs_;
  const std::vector<FacetType>& facets_;
  const Tile& tile_;
  const std::vector<std::uint32_t>& members_;
  LeafLines<A> lines_;
  CellCutter<A> cutter_;
  CellSigns scratch_;
};

template <Arithmetic A, QueryEffects E>
Cell Leaf<A, E>::cut(const Cell& cell, const Region& region, std::vector<Cell>& outside) {
  const std::size_t before = outside.size();
  Cell inside = cell;
  for (const Side& h : region) {
    const auto [positive, negative] = cutter_.classify(inside, h, scratch_);
    if (!positive) {
      // They do not overlap: whatever was cut off on the way here belongs to the whole again.
      outside.resize(before);
      outside.push_back(cell);
      return {};
    }
    if (!negative) continue;
    outside.push_back(cutter_.part(inside, h, scratch_, Sign::negative));
    inside = cutter_.part(inside, h, scratch_, Sign::positive);
  }
  return inside;
}

/// A ray well inside the cell, certainly so; false where float64 cannot tell.
template <Arithmetic A, QueryEffects E>
bool Leaf<A, E>::sample_in(const Cell& cell, Direction& sample) const {
  Vec3d sum;
  for (const Direction& v : cell.vertices) {
    const double size = largest(v.approx.v);
    if (!(size > 0) || !(size < HUGE_VAL)) return false;
    sum = sum + (1 / size) * v.approx.v;
  }
  const Vec3d at = window_coordinates(signs_.geometry(), sum);
  if (!std::isfinite(at.x) || !std::isfinite(at.y)) return false;
  sample = window_direction(signs_, at);
  return std::all_of(cell.lines.begin(), cell.lines.end(), [&](const Side& l) {
    const Sign wanted = l.negated ? Sign::negative : Sign::positive;
    return signs_.quick_side(*l.line, sample) == wanted;
  });
}

/// Whether o hides t along the sample; what cannot be told cheaply counts as blocked.
template <Arithmetic A, QueryEffects E>
typename Leaf<A, E>::Meeting Leaf<A, E>::meet(std::uint32_t o, std::uint32_t t, const Direction& sample) {
  for (const Line& e : facets_[o].edges)
    if (signs_.quick_side(e, sample) == Sign::negative) return Meeting::clear;
  if constexpr (E.front_clip)
    if (facets_[o].cut && signs_.quick_side(*lines_.front(o).line, sample) == Sign::negative)
      return Meeting::clear;
  const Side nearer = lines_.depth(o, t);
  if (nearer.line == nullptr) return Meeting::clear;
  const Sign farther = nearer.negated ? Sign::positive : Sign::negative;
  return signs_.quick_side(*nearer.line, sample) == farther ? Meeting::clear : Meeting::blocked;
}

template <Arithmetic A, QueryEffects E>
void Leaf<A, E>::subtract(std::uint32_t o, std::uint32_t t, std::vector<Cell>& pieces) {
  const Side nearer = lines_.depth(o, t);
  if (nearer.line == nullptr) return;
  Region region{nearer};
  lines_.template append_cone<E.front_clip>(o, region);
  std::vector<Cell> remaining;
  for (const Cell& piece : pieces) cut(piece, region, remaining);
  pieces = std::move(remaining);
}

/// Pieces are faces of an arrangement of at most 5 lines per member, which bounds how many there can be.
/// Rounded signs can leave pieces that nothing removes; they are given up at a count that certain ones hardly
/// ever reach, and the facet is called visible.
template <Arithmetic A, QueryEffects E>
bool Leaf<A, E>::too_many(std::size_t pieces) const {
  const std::size_t lines = 5 * members_.size() + 8;
  if constexpr (A == Arithmetic::doubles) return pieces > 16 * lines;
  if (pieces > lines * lines)
    throw Error(Error::Code::internal, "point", "more pieces than an arrangement can have faces");
  return false;
}

template <Arithmetic A, QueryEffects E>
Sight Leaf<A, E>::look(std::uint32_t t) {
  Region cone;
  lines_.template append_cone<E.front_clip>(t, cone);
  std::vector<Cell> pieces;
  {
    std::vector<Cell> ignored;
    Cell seen = cut(make_cell(tile_, signs_.geometry().handedness), cone, ignored);
    if (seen.empty()) return {};
    pieces.push_back(std::move(seen));
  }
  std::vector<std::uint32_t> waiting;
  for (const std::uint32_t o : members_)
    if (o != t && (!E.see_through || facets_[o].occludes)) waiting.push_back(o);

  while (!pieces.empty() && !too_many(pieces.size())) {
    Sight sight;
    sight.visible = true;
    if (waiting.empty()) {
      sight.cell = std::move(pieces.back());
      return sight;
    }
    // The sample names the occluder to subtract next; where it names none, t is seen. Where there is no
    // certain sample, every occluder will have to go, whatever the order.
    auto next = waiting.begin();
    if (sample_in(pieces.back(), sight.sample)) {
      next = std::find_if(waiting.begin(), waiting.end(),
                          [&](std::uint32_t o) { return meet(o, t, sight.sample) == Meeting::blocked; });
      if (next == waiting.end()) {
        sight.sampled = true;
        sight.cell = std::move(pieces.back());
        return sight;
      }
    }
    const std::uint32_t o = *next;
    *next = waiting.back();
    waiting.pop_back();
    subtract(o, t, pieces);
  }
  Sight sight;
  sight.visible = !pieces.empty();
  return sight;
}

/// Whether the ray certainly passes o by, or meets it beyond t, or o lies in t's plane.
template <Arithmetic A, QueryEffects E>
bool Leaf<A, E>::misses(std::uint32_t o, std::uint32_t t, const Vec3<ExactNumber>& ray) {
  Region region;
  if (const Side nearer = lines_.depth(o, t); nearer.line != nullptr)
    region.push_back(nearer);
  else
    return true;
  lines_.template append_cone<E.front_clip>(o, region);
  return std::any_of(region.begin(), region.end(),
                     [&](const Side& s) { return exact_side(signs_.geometry(), s, ray) == Sign::negative; });
}

template <Arithmetic A, QueryEffects E>
template <class Clear>
bool Leaf<A, E>::clear_of_all(std::uint32_t t, const Clear& clear) const {
  return std::all_of(members_.begin(), members_.end(),
                     [&](std::uint32_t o) { return o == t || !facets_[o].occludes || clear(o); });
}

template <Arithmetic A, QueryEffects E>
WitnessPoint Leaf<A, E>::witness(std::uint32_t t, const Sight& sight) {
  if (sight.sampled &&
      clear_of_all(t, [&](std::uint32_t o) { return meet(o, t, sight.sample) == Meeting::clear; }))
    return {ExactNumber(sight.sample.numbers.x), ExactNumber(sight.sample.numbers.y)};
  // What remains after subtraction may still be touched from behind, along at most four lines for each
  // member, so that among enough points one lies on none.
  Cell cell = sight.cell;
  if (sight.sampled) {
    // The sample proved its own neighbourhood only: subtract everything to get a cell that is seen as a
    // whole.
    std::vector<Cell> pieces{std::move(cell)};
    for (const std::uint32_t o : members_)
      if (o != t && facets_[o].occludes) subtract(o, t, pieces);
    if (pieces.empty()) throw Error(Error::Code::internal, "witness", "a sampled facet that is hidden");
    cell = std::move(pieces.back());
  }
  const std::size_t attempts = 4 * members_.size() * cell.vertices.size() + 16;
  for (std::size_t k = 0; k < attempts; ++k) {
    const WitnessPoint p = interior_point(signs_.geometry(), cell, k);
    const Vec3<ExactNumber> ray = exact_ray(signs_.geometry(), p);
    if (clear_of_all(t, [&](std::uint32_t o) { return misses(o, t, ray); })) return p;
  }
  throw Error(Error::Code::internal, "witness", "every point of a free cell is touched by an occluder");
}

}  // namespace provis
