#pragma once
// Where the sampled methods put what they have proven to be visible.

#include <algorithm>
#include <unordered_set>

#include "src/point/engine.hpp"
#include "src/point/leaf.hpp"

namespace provis {

/// What one block of the window adds to the answer. The set is shared by all blocks unless the answer says
/// where each facet was seen: that must not depend on the threads.
template <Arithmetic A>
class Findings {
 public:
  Findings(const FrameQuery& query, const Facets& facets, SeenFacets& seen, Outcome& outcome)
      : query_(query), facets_(facets), seen_(seen), outcome_(outcome) {}

  QueryStats& stats() { return outcome_.stats; }
  bool seen_here(std::uint32_t facet) const { return here_.count(facet) != 0; }

  /// Whether a location makes no witness: at infinity it may lie on an occluder that only touches the window,
  /// which is no facet of the frame.
  bool needs_leaf() const { return query_.options.witnesses && query_.geometry.at_infinity; }

  /// The facet is seen along the ray through a float64 point of the window, and nothing touches it there.
  void see(std::uint32_t facet, double x, double y) {
    if (!here_.insert(facet).second) return;
    ++stats().samples;
    if (add(facet)) outcome_.witnesses.push_back({ExactNumber(x), ExactNumber(y)});
  }

  /// The facet is seen somewhere in the leaf.
  template <QueryEffects E>
  void see(std::uint32_t facet, Leaf<A, E>& leaf) {
    if (!here_.insert(facet).second) return;
    ++stats().samples;
    if (add(facet)) outcome_.witnesses.push_back(leaf.witness(facet, leaf.look(facet)));
  }

  /// Decides exactly whether the leaf shows the facet.
  template <QueryEffects E>
  bool decide(Leaf<A, E>& leaf, std::uint32_t facet) {
    ++stats().subtractions;
    const FacetSight sight = leaf.look(facet);
    if (!sight.visible) return false;
    here_.insert(facet);
    if (add(facet)) outcome_.witnesses.push_back(leaf.witness(facet, sight));
    return true;
  }

 private:
  /// Whether it needs a witness.
  bool add(std::uint32_t facet) {
    const bool witnesses = query_.options.witnesses;
    if (seen_.set(facet) || witnesses) outcome_.found.push_back(facets_.facets[facet].id);
    return witnesses;
  }

  const FrameQuery& query_;
  const Facets& facets_;
  SeenFacets& seen_;
  Outcome& outcome_;
  std::unordered_set<std::uint32_t> here_;
};

}  // namespace provis
