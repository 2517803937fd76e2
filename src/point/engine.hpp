#pragma once
// The engines: one instantiation per arithmetic policy and per combination of effects that matters.

#include <numeric>

#include "predicates/for_policy.hpp"
#include "src/point/effects.hpp"
#include "src/point/guard.hpp"
#include "src/point/parts.hpp"
#include "src/point/traversal.hpp"
#include "src/scene/parallel.hpp"

namespace provis {

/// Resolves one part of a frame. seen: by primitive id, shared by all parts; or null where what is found must
/// not depend on the order of work: then `known` says what needs no further proof.
template <Arithmetic A, QueryEffects E>
Outcome resolve_part(const Scene& scene, const FrameQuery& query, const Parts& parts, std::size_t part,
                     SeenFacets* seen, const std::vector<std::uint8_t>& known) {
  Outcome outcome;
  // Borders are rounded as they were when the triangles were handed out: before the guard.
  const Window window = parts.window(part);
  const RoundingGuard<A> guard;
  Signs<A> signs(query.geometry, outcome.stats.signs);
  const Facets facets = make_facets(signs, scene, window, parts.members(part));
  SeenFacets own(seen != nullptr ? 0 : facets.facets.size());
  if (seen == nullptr)
    for (std::uint32_t f = 0; f < facets.facets.size(); ++f)
      if (known[facets.facets[f].id]) own.set(f);
  Traversal<A, E>(query, signs, facets, seen != nullptr ? *seen : own, seen != nullptr, outcome).run(window);
  return outcome;
}

/// Resolves one frame: its parts in parallel, the fullest first, added up in their order.
template <Arithmetic A, QueryEffects E>
Outcome resolve_frame(const Scene& scene, const FrameQuery& query, const std::vector<std::uint8_t>& known) {
  const Parts parts = make_parts(scene, query.geometry, query.window, query.context);
  // Rounded signs make even the set depend on the order of work.
  const bool canonical = query.options.witnesses || A == Arithmetic::doubles;
  SeenFacets shared(canonical ? std::vector<std::uint8_t>{} : known);
  std::vector<std::size_t> order(parts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return parts.members(a).size() > parts.members(b).size();
  });
  std::vector<Outcome> outcomes(parts.size());
  parallel_queue(parts.size(), [&](std::size_t k) {
    const std::size_t part = order[k];
    outcomes[part] = resolve_part<A, E>(scene, query, parts, part, canonical ? nullptr : &shared, known);
    query.progress.add(1 / static_cast<double>(parts.size()));
  });
  Outcome outcome;
  for (Outcome& o : outcomes) outcome.add(std::move(o));
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
