#pragma once
// Deciding, in one small rectangle, which facets are visible there: certified samples first, then covers, and
// exact subtraction for what neither settles.

#include <algorithm>
#include <cmath>
#include <vector>

#include "provis/error.hpp"
#include "src/point/effects.hpp"
#include "src/point/fragment.hpp"
#include "src/point/front_to_back.hpp"
#include "src/point/leaf_lines.hpp"
#include "src/point/witness_point.hpp"

namespace provis {

/// How a facet was found visible: by one certain sample, or because nothing was left to subtract.
struct FacetSight {
  bool visible = false;
  bool sampled = false;
  Direction sample;  ///< where sampled: a window ray on which the facet is certainly seen
  /// A cell of the image in which it is seen somewhere, everywhere if not sampled; empty: all of the tile.
  Cell cell;
};

template <Arithmetic A, QueryEffects E>
class Leaf {
 public:
  /// members: indices of every facet that may have hits in the tile.
  Leaf(Signs<A>& signs, const Facets& facets, PartLines<A>& part, const Tile& tile,
       const std::vector<std::uint32_t>& members)
      : signs_(signs),
        facets_(facets.facets),
        tile_(tile),
        members_(front_to_back(facets.facets, members, tile.window)),
        lines_(signs, facets, part),
        cutter_(signs, part.points) {}

  /// Whether one ray in the middle of facet t certainly shows it; the rest of the answer is open.
  bool glance(std::uint32_t t, FacetSight& sight);

  /// The occluders that may come before facet t somewhere in the tile, front to back.
  std::vector<std::uint32_t> rivals(std::uint32_t t) const;

  /// Whether one of a few rays in what plain polygons leave of it does. `waiting` holds its rivals;
  /// those that blocked one come first afterwards.
  bool glimpse(std::uint32_t t, std::vector<std::uint32_t>& waiting, FacetSight& sight);

  /// Whether facet t is visible within the tile.
  FacetSight look(std::uint32_t t);

  /// A ray on which facet t is hit strictly inside, and which meets no other occluder up to there, not even
  /// at the hit (R11). Requires: sight is what look, glance or glimpse gave.
  WitnessPoint witness(std::uint32_t t, const FacetSight& sight);

  const std::vector<OrderedFacet>& members() const { return members_; }
  LeafLines<A>& lines() { return lines_; }
  CellCutter<A>& cutter() { return cutter_; }

  /// Cuts the region out of the cell: appends what remains to `outside`, returns the part inside (empty if
  /// the two do not overlap; then the whole cell remains).
  Cell cut(const Cell& cell, const Region& region, std::vector<Cell>& outside);

 private:
  enum class Meeting { clear, blocked };
  using Members = std::vector<std::uint32_t>;

  static constexpr int most_rounds = 4;  ///< of a glimpse: what is seen is mostly seen at once

  PolygonCorner middle(const Polygon& polygon) const;
  void show(FacetSight& sight, const PolygonCorner& at) const;
  bool shows(std::uint32_t t, const PolygonCorner& at);
  Meeting meet(std::uint32_t o, std::uint32_t t, const PolygonCorner& at);
  /// Plain doubles take the value on a ray at its word; bounds of rectangles are certain under every policy.
  static double claimed(double error) { return A == Arithmetic::doubles ? 0 : error; }
  double edge_value(std::uint32_t t, std::size_t k, const PolygonCorner& at);
  double nearer_value(std::uint32_t o, std::uint32_t t, const PolygonCorner& at);
  FacetSight subtract_all(std::uint32_t t, Members& waiting);
  /// The part of the tile in which t has hits; empty if there is none.
  Cell cone_in_tile(std::uint32_t t);

  bool sample_in(const Cell& cell, PolygonCorner& at);
  bool misses(std::uint32_t o, std::uint32_t t, const Vec3<ExactNumber>& ray);
  template <class Clear>
  bool clear_of_all(std::uint32_t t, const Clear& clear) const;
  void subtract(std::uint32_t o, std::uint32_t t, std::vector<Cell>& pieces);
  bool too_many(std::size_t pieces) const;

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  const Tile& tile_;
  std::vector<OrderedFacet> members_;  ///< front to back
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
bool Leaf<A, E>::sample_in(const Cell& cell, PolygonCorner& at) {
  Vec3d sum;
  for (const Direction& v : cell.vertices) {
    const double size = largest(v.approx.v);
    if (!(size > 0) || !(size < HUGE_VAL)) return false;
    sum = sum + (1 / size) * v.approx.v;
  }
  const Vec3d middle = window_coordinates(signs_.geometry(), sum);
  at = {middle.x, middle.y};
  return quickly_inside(signs_, cell, middle);
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
typename Leaf<A, E>::Members Leaf<A, E>::rivals(std::uint32_t t) const {
  const Facet& g = facets_[t];
  const Window where = intersection(g.box, tile_.window);
  const double farthest = g.depth.lowest(where);
  Members list;
  for (const auto& [o, nearest] : members_) {
    const Facet& f = facets_[o];
    if (!f.occludes || nearest < farthest) break;
    if (o == t || !overlap(f.box, where)) continue;
    const Window both = intersection(f.box, where);
    if (difference(f.depth, g.depth).highest(both) < 0) continue;
    if (std::none_of(std::begin(f.inside), std::end(f.inside),
                     [&](const WindowFunction& e) { return e.highest(both) < 0; }))
      list.push_back(o);
  }
  return list;
}

/// Rounding may leave the tile, which is all that is known of the members.
template <Arithmetic A, QueryEffects E>
PolygonCorner Leaf<A, E>::middle(const Polygon& polygon) const {
  const PolygonCorner at = polygon.middle();
  const Window& w = tile_.window;
  return {std::clamp(at.x, w.x0, w.x1), std::clamp(at.y, w.y0, w.y1)};
}

template <Arithmetic A, QueryEffects E>
void Leaf<A, E>::show(FacetSight& sight, const PolygonCorner& at) const {
  sight.visible = sight.sampled = true;
  sight.sample = window_direction(signs_, {at.x, at.y, 0});
}

template <Arithmetic A, QueryEffects E>
FacetSight Leaf<A, E>::look(std::uint32_t t) {
  Members waiting = rivals(t);
  // The slow policies are there to take signs.
  if constexpr (A == Arithmetic::chain || A == Arithmetic::doubles)
    if (FacetSight sight; glimpse(t, waiting, sight)) return sight;
  return subtract_all(t, waiting);
}

template <Arithmetic A, QueryEffects E>
bool Leaf<A, E>::glance(std::uint32_t t, FacetSight& sight) {
  Polygon fragment(tile_.window);
  for (const WindowFunction& e : facets_[t].inside) fragment = fragment.clipped(e, 1);
  if (fragment.empty()) return false;
  const PolygonCorner at = middle(fragment);
  if (!shows(t, at)) return false;
  const double farthest = facets_[t].depth.at(at.x, at.y) - facets_[t].depth.error;
  for (const auto& [o, nearest] : members_) {
    if (!facets_[o].occludes || nearest < farthest) break;
    if (o != t && meet(o, t, at) == Meeting::blocked) return false;
  }
  show(sight, at);
  return true;
}

/// Whether t is certainly hit strictly inside, beyond the window.
template <Arithmetic A, QueryEffects E>
bool Leaf<A, E>::shows(std::uint32_t t, const PolygonCorner& at) {
  const Facet& f = facets_[t];
  if constexpr (E.front_clip)
    if (f.cut && !(f.depth.at(at.x, at.y) < -claimed(f.depth.error))) return false;
  for (std::size_t k = 0; k < 3; ++k)
    if (!(edge_value(t, k, at) > claimed(f.inside[k].error))) return false;
  return true;
}

/// The value of an edge's function; plain doubles, when they are checked, answer for its sign.
template <Arithmetic A, QueryEffects E>
double Leaf<A, E>::edge_value(std::uint32_t t, std::size_t k, const PolygonCorner& at) {
  const double value = facets_[t].inside[k].at(at.x, at.y);
  if constexpr (A == Arithmetic::doubles)
    if (signs_.geometry().checked) [[unlikely]]
      signs_.check(lines_.of(t).edges[k], window_direction(signs_, {at.x, at.y, 0}), sign_of(value));
  return value;
}

/// Likewise how much nearer o is than t.
template <Arithmetic A, QueryEffects E>
double Leaf<A, E>::nearer_value(std::uint32_t o, std::uint32_t t, const PolygonCorner& at) {
  const double value = facets_[o].depth.at(at.x, at.y) - facets_[t].depth.at(at.x, at.y);
  if constexpr (A == Arithmetic::doubles)
    if (signs_.geometry().checked) [[unlikely]]
      if (const Side nearer = lines_.depth(o, t); nearer.line != nullptr) {
        const Sign s = sign_of(value);
        signs_.check(*nearer.line, window_direction(signs_, {at.x, at.y, 0}), nearer.negated ? -s : s);
      }
  return value;
}

template <Arithmetic A, QueryEffects E>
typename Leaf<A, E>::Meeting Leaf<A, E>::meet(std::uint32_t o, std::uint32_t t, const PolygonCorner& at) {
  if constexpr (A == Arithmetic::mpfr || A == Arithmetic::exact) {
    const Side nearer = lines_.depth(o, t);
    if (nearer.line == nullptr) return Meeting::clear;
    Region region{nearer};
    lines_.template append_cone<E.front_clip>(o, region);
    const Direction sample = window_direction(signs_, {at.x, at.y, 0});
    const bool misses = std::any_of(region.begin(), region.end(), [&](const Side& s) {
      return signs_.side(*s.line, sample) == (s.negated ? Sign::positive : Sign::negative);
    });
    return misses ? Meeting::clear : Meeting::blocked;
  }
  const Facet &f = facets_[o], &g = facets_[t];
  if (at.x < f.box.x0 || at.x > f.box.x1 || at.y < f.box.y0 || at.y > f.box.y1) return Meeting::clear;
  for (std::size_t k = 0; k < 3; ++k)
    if (edge_value(o, k, at) < -claimed(f.inside[k].error)) return Meeting::clear;
  if constexpr (E.front_clip)
    if (f.cut && f.depth.at(at.x, at.y) > claimed(f.depth.error)) return Meeting::clear;
  const double before = nearer_value(o, t, at);
  const double error = claimed((f.depth.error + g.depth.error) * (1 + 0x1p-20));
  if (before < -error) return Meeting::clear;
  if (before > error) return Meeting::blocked;
  return lines_.depth(o, t).line == nullptr ? Meeting::clear : Meeting::blocked;
}

template <Arithmetic A, QueryEffects E>
bool Leaf<A, E>::glimpse(std::uint32_t t, Members& waiting, FacetSight& sight) {
  std::vector<Polygon> pieces{Polygon(tile_.window)};
  for (const WindowFunction& e : facets_[t].inside) pieces[0] = pieces[0].clipped(e, 1);
  const double least =
      1e-9 * pieces[0].area();  // not worth a look; what is given up goes on to certain signs
  auto met = waiting.begin();
  for (int round = 0; !pieces.empty() && round < most_rounds; ++round) {
    const Polygon& piece = *std::max_element(
        pieces.begin(), pieces.end(), [](const Polygon& p, const Polygon& q) { return p.area() < q.area(); });
    if (!(piece.area() > least)) return false;
    const PolygonCorner at = middle(piece);
    if (!shows(t, at)) return false;
    const auto next = std::find_if(waiting.begin(), waiting.end(),
                                   [&](std::uint32_t o) { return meet(o, t, at) == Meeting::blocked; });
    if (next == waiting.end()) {
      show(sight, at);
      return true;
    }
    // Polygons that are rounded may leave slivers of what is gone.
    if (next < met) return false;
    const std::uint32_t o = *next;
    std::swap(*next, *met++);
    const WindowFunction nearer = difference(facets_[o].depth, facets_[t].depth);
    const WindowFunction* region[4] = {&nearer, &facets_[o].inside[0], &facets_[o].inside[1],
                                       &facets_[o].inside[2]};
    std::vector<Polygon> remaining;
    for (Polygon inside : pieces) {
      for (const WindowFunction* h : region) {
        if (const Polygon outside = inside.clipped(*h, -1); outside.area() > least)
          remaining.push_back(outside);
        inside = inside.clipped(*h, 1);
        if (inside.empty()) break;
      }
    }
    pieces = std::move(remaining);
  }
  return false;
}

template <Arithmetic A, QueryEffects E>
Cell Leaf<A, E>::cone_in_tile(std::uint32_t t) {
  Region cone;
  lines_.template append_cone<E.front_clip>(t, cone);
  std::vector<Cell> ignored;
  return cut(make_cell(tile_, signs_.geometry().handedness), cone, ignored);
}

/// Exactly, whatever the position: keeps the pieces of t's cell in which nothing hides it so far.
template <Arithmetic A, QueryEffects E>
FacetSight Leaf<A, E>::subtract_all(std::uint32_t t, Members& waiting) {
  Cell seen = cone_in_tile(t);
  if (seen.empty()) return {};
  std::vector<Cell> pieces{std::move(seen)};
  std::reverse(waiting.begin(), waiting.end());
  while (!pieces.empty() && !too_many(pieces.size())) {
    FacetSight sight;
    sight.visible = true;
    if (waiting.empty()) {
      sight.cell = std::move(pieces.back());
      return sight;
    }
    // The sample names the occluder to subtract next; where it names none, t is seen. Where there is no
    // certain sample, every occluder will have to go, whatever the order.
    auto next = waiting.end() - 1;
    if (PolygonCorner at; sample_in(pieces.back(), at)) {
      const auto blocks = [&](std::uint32_t o) { return meet(o, t, at) == Meeting::blocked; };
      const auto found = std::find_if(waiting.rbegin(), waiting.rend(), blocks);
      if (found == waiting.rend()) {
        show(sight, at);
        sight.cell = std::move(pieces.back());
        return sight;
      }
      next = found.base() - 1;
    }
    const std::uint32_t o = *next;
    waiting.erase(next);
    subtract(o, t, pieces);
  }
  FacetSight sight;
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
  return std::all_of(members_.begin(), members_.end(), [&](const OrderedFacet& m) {
    return m.facet == t || !facets_[m.facet].occludes || clear(m.facet);
  });
}

template <Arithmetic A, QueryEffects E>
WitnessPoint Leaf<A, E>::witness(std::uint32_t t, const FacetSight& sight) {
  const PolygonCorner at{sight.sample.numbers.x, sight.sample.numbers.y};
  if (sight.sampled && clear_of_all(t, [&](std::uint32_t o) { return meet(o, t, at) == Meeting::clear; }))
    return {ExactNumber(sight.sample.numbers.x), ExactNumber(sight.sample.numbers.y)};
  // What remains after subtraction may still be touched from behind, along at most four lines for each
  // member, so that among enough points one lies on none.
  Cell cell = sight.cell;
  if (sight.sampled) {
    // The sample proved its own neighbourhood only: subtract everything to get a cell that is seen as a
    // whole. A glance brings no cell; that bounds of rectangles were sure of what the value on the ray is not
    // happens between nearly coplanar facets.
    std::vector<Cell> pieces{cell.empty() ? cone_in_tile(t) : std::move(cell)};
    for (const auto& [o, nearest] : members_)
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
