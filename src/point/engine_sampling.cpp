#include "src/point/engine_sampling.hpp"

#include "src/point/aggressive.hpp"
#include "src/point/sampled.hpp"

namespace provis {
namespace {

template <Arithmetic A>
Outcome sample_frame(const Scene& scene, const FrameQuery& query, const std::vector<std::uint8_t>&) {
  Outcome outcome;
  const Facets facets =
      make_facets<A>(scene, query.geometry, query.window, query.context, outcome.stats.signs);
  SeenFacets seen(facets.facets.size());
  outcome.add(query.options.method == Method::sampled ? SampledFrame<A>(query, facets, seen).run()
                                                      : AggressiveFrame<A>(query, facets, seen).run());
  return outcome;
}

}  // namespace

FrameEngine sampling_engine(Arithmetic arithmetic) {
  return for_policy(arithmetic, []<Arithmetic A>() -> FrameEngine { return &sample_frame<A>; });
}

}  // namespace provis
