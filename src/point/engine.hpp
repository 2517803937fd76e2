#pragma once
// The engines: one instantiation per arithmetic policy and per combination of effects that matters.

#include "src/point/effects.hpp"
#include "src/point/traversal.hpp"

namespace provis {

/// Resolves one frame.
template <Arithmetic A, QueryEffects E>
Outcome resolve_frame(const Scene& scene, const FrameQuery& query, const std::vector<std::uint8_t>& known) {
  Outcome outcome;
  const Facets<A> facets =
      make_facets<A>(scene, query.geometry, query.window, query.context, outcome.stats.signs);
  outcome.add(Traversal<A, E>(query, facets, known).run());
  return outcome;
}

using FrameEngine = Outcome (*)(const Scene&, const FrameQuery&, const std::vector<std::uint8_t>&);

/// The engine compiled for a policy and at least these effects.
FrameEngine doubles_engine(QueryEffects effects);
FrameEngine chain_engine(QueryEffects effects);
FrameEngine mpfr_engine();
FrameEngine exact_engine();

/// The engine of one policy that simulates exactly the effects asked for.
template <Arithmetic A>
FrameEngine select_engine(QueryEffects e) {
  if (e.see_through)
    return e.front_clip ? &resolve_frame<A, QueryEffects{true, true}>
                        : &resolve_frame<A, QueryEffects{true, false}>;
  return e.front_clip ? &resolve_frame<A, QueryEffects{false, true}>
                      : &resolve_frame<A, QueryEffects{false, false}>;
}

}  // namespace provis
