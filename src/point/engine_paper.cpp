#include "src/point/engine_paper.hpp"

#include "src/point/aggressive.hpp"
#include "src/point/paper_part.hpp"

namespace provis {
namespace {

template <Arithmetic A>
void count(const PaperFrameData<A>& data, IterationStats& stats) {
  const auto n = static_cast<std::uint32_t>(data.facets.facets.size());
  for (std::uint32_t f = 0; f < n; ++f) {
    stats.aggressive += data.aggressive.get(f);
    stats.visible += data.found.get(f);
    stats.visible_after_first += data.found_first.get(f);
    stats.undecided_after_first += data.undecided.get(f) && !data.found_first.get(f);
  }
  stats.undecided = n - stats.aggressive;
  stats.visible += stats.aggressive;
  stats.visible_after_first += stats.aggressive;
  const Window& w = data.query.window;
  stats.area = (w.x1 - w.x0) * (w.y1 - w.y0);
  // A window so large says nothing in float64.
  if (!std::isfinite(stats.area) || !std::isfinite(stats.area_missed)) stats.area = stats.area_missed = 0;
}

template <Arithmetic A>
Outcome paper_frame(const Scene& scene, const FrameQuery& query, const std::vector<std::uint8_t>&) {
  Outcome outcome;
  const Facets facets =
      make_facets<A>(scene, query.geometry, query.window, query.context, outcome.stats.signs);
  const WindowMap map(query.geometry);
  const std::size_t n = facets.facets.size();
  SeenFacets aggressive(n), found(n), found_first(n), undecided(n);
  outcome.add(AggressiveFrame<A>(query, facets, aggressive).run());
  const PaperFrameData<A> data{query, facets, map, aggressive, found, found_first, undecided};
  outcome.add(PaperFrame<A>(data).run());
  count(data, outcome.stats.iteration);
  return outcome;
}

}  // namespace

FrameEngine paper_engine(Arithmetic arithmetic) {
  return for_policy(arithmetic, []<Arithmetic A>() -> FrameEngine { return &paper_frame<A>; });
}

}  // namespace provis
