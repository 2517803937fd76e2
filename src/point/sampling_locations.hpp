#pragma once
// Rays at which a block of the window is looked along, and what is proven to be seen there.

#include <vector>

#include "src/point/leaf_lines.hpp"
#include "src/point/looks.hpp"
#include "src/point/tile.hpp"

namespace provis {

/// A ray through a float64 point of the window, and the facets that may be seen along it.
struct SamplingLocation {
  double x = 0, y = 0;
  double reached = -HUGE_VAL;  ///< some occluder hit inside is certainly as near as this
  std::uint32_t reached_by = no_id;
  std::uint32_t next = no_id;            ///< of the same pixel
  std::uint32_t candidate = no_id;       ///< a facet that may be seen; more of them are in Locations::others_
  double candidate_at_most = -HUGE_VAL;  ///< how near it may be
  bool candidate_inside = false;         ///< certainly hit inside
};

/// What a location says about a facet that is hit there in its relative interior.
enum class Look {
  hidden,   ///< an occluder is strictly nearer
  touched,  ///< none is, but one of another plane is hit at the same distance: nothing is proven
  visible,  ///< every occluder hit at this distance or nearer lies in the facet's plane (R11)
};

template <Arithmetic A>
class SamplingLocations {
 public:
  SamplingLocations(Signs<A>& signs, const Facets& facets, LeafLines<A>& lines)
      : signs_(signs), facets_(facets.facets), lines_(lines) {}

  std::uint32_t add(double x, double y) {
    SamplingLocation& l = all_.emplace_back();
    l.x = x;
    l.y = y;
    return static_cast<std::uint32_t>(all_.size() - 1);
  }
  std::size_t size() const { return all_.size(); }
  SamplingLocation& operator[](std::uint32_t k) { return all_[k]; }
  const SamplingLocation& operator[](std::uint32_t k) const { return all_[k]; }

  /// Lets the location see the facet, unless it is certainly passed by or certainly behind.
  void offer(std::uint32_t location, std::uint32_t facet);

  /// Calls say(location, facet, look) for every facet that is hit inside and perhaps not hidden, in the order
  /// of the locations. Every facet that can matter must have been offered.
  template <class Say>
  void resolve(const Say& say);

 private:
  struct Other {
    std::uint32_t location, facet;
    double at_most;
  };

  template <class Say>
  void decide(std::uint32_t location, const std::vector<std::uint32_t>& candidates, const Say& say);
  Sign cone_side(std::uint32_t facet, const Direction& ray);
  Sign front_side(std::uint32_t facet, const Direction& ray);
  Look look(std::uint32_t facet, const std::vector<std::uint32_t>& occluders, const Direction& ray);

  Signs<A>& signs_;
  const std::vector<Facet>& facets_;
  LeafLines<A>& lines_;
  std::vector<SamplingLocation> all_;
  std::vector<Other> others_;
};

template <Arithmetic A>
void SamplingLocations<A>::offer(std::uint32_t location, std::uint32_t facet) {
  SamplingLocation& l = all_[location];
  const Facet& f = facets_[facet];
  const double near = f.depth.at(l.x, l.y);
  const double at_most = near + f.depth.error;
  if (at_most < l.reached) return;
  const Hit met = hit(f, l.x, l.y);
  if (met == Hit::none) return;
  if (const double at_least = near - f.depth.error;
      met == Hit::inside && f.occludes && at_least > l.reached) {
    l.reached = at_least;
    l.reached_by = facet;
  }
  if (l.candidate != no_id && !(l.candidate_at_most < l.reached)) {
    others_.push_back({location, facet, at_most});
    return;
  }
  l.candidate = facet;
  l.candidate_at_most = at_most;
  l.candidate_inside = met == Hit::inside;
}

template <Arithmetic A>
template <class Say>
void SamplingLocations<A>::resolve(const Say& say) {
  std::erase_if(others_, [&](const Other& o) { return o.at_most < all_[o.location].reached; });
  std::stable_sort(others_.begin(), others_.end(),
                   [](const Other& a, const Other& b) { return a.location < b.location; });
  std::vector<std::uint32_t> candidates;
  auto other = others_.begin();
  for (std::uint32_t k = 0; k < all_.size(); ++k) {
    const SamplingLocation& l = all_[k];
    if (l.candidate == no_id) continue;
    candidates.assign(l.candidate_at_most < l.reached ? 0 : 1, l.candidate);
    for (; other != others_.end() && other->location == k; ++other) candidates.push_back(other->facet);
    if (candidates.size() == 1 && candidates.front() == l.candidate && l.candidate_inside)
      say(k, l.candidate, Look::visible);
    else
      decide(k, candidates, say);
  }
}

template <Arithmetic A>
template <class Say>
void SamplingLocations<A>::decide(std::uint32_t location, const std::vector<std::uint32_t>& candidates,
                                  const Say& say) {
  const Direction ray = window_direction(signs_, {all_[location].x, all_[location].y, 0});
  std::vector<std::uint32_t> inside, occluders;
  bool starts_on_occluder = false;  // at distance 0, which is no hit (R6) and proves nothing (R11)
  for (const std::uint32_t f : candidates) {
    const Sign cone = cone_side(f, ray), front = front_side(f, ray);
    if (cone == Sign::negative || front == Sign::negative) continue;
    if (front == Sign::zero) {
      starts_on_occluder |= facets_[f].occludes;
      continue;
    }
    if (cone == Sign::positive) inside.push_back(f);
    if (facets_[f].occludes) occluders.push_back(f);
  }
  for (const std::uint32_t f : inside) {
    const Look seen = look(f, occluders, ray);
    say(location, f, starts_on_occluder ? std::min(seen, Look::touched) : seen);
  }
}

/// Positive inside, zero on the border, negative outside.
template <Arithmetic A>
Sign SamplingLocations<A>::cone_side(std::uint32_t facet, const Direction& ray) {
  Sign side = Sign::positive;
  for (const Line& e : lines_.of(facet).edges) side = std::min(side, signs_.side(e, ray));
  return side;
}

template <Arithmetic A>
Sign SamplingLocations<A>::front_side(std::uint32_t facet, const Direction& ray) {
  return facets_[facet].cut ? signs_.side(*lines_.front(facet).line, ray) : Sign::positive;
}

template <Arithmetic A>
Look SamplingLocations<A>::look(std::uint32_t facet, const std::vector<std::uint32_t>& occluders,
                                const Direction& ray) {
  Look answer = Look::visible;
  for (const std::uint32_t o : occluders) {
    if (o == facet) continue;
    const Side nearer = lines_.depth(o, facet);
    if (nearer.line == nullptr) continue;
    const Sign side = signs_.side(*nearer.line, ray);
    if (side == Sign::zero)
      answer = Look::touched;
    else if (side == (nearer.negated ? Sign::negative : Sign::positive))
      return Look::hidden;
  }
  return answer;
}

}  // namespace provis
