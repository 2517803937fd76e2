#include "src/report/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace provis {

std::string name(const Way& way) {
  if (way.cell == CellMethod::lower)
    return way.viewpoints > 0 ? fmt::format("viewpoints {}", way.viewpoints) : "lower";
  if (way.cell) {
    if (way.cell == CellMethod::bounds) return "bounds";
    return fmt::format("cos {}x{}", way.pixels.width, way.pixels.height);
  }
  switch (way.method) {
    case Method::sampled:
      if (way.viewpoints > 0) return fmt::format("sampled {}", way.viewpoints);
      return fmt::format("sampled {0}x{0}", way.samples);
    case Method::aggressive:
      return "aggressive";
    case Method::exact:
      break;
  }
  return std::string(name(way.arithmetic)) + (way.plain ? " (plain)" : "");
}

bool refines(const Way& finer, const Way& coarser) {
  if (finer.cell != coarser.cell || finer.method != coarser.method) return false;
  if (finer.cell == CellMethod::lower) return coarser.viewpoints > 0 && finer.viewpoints > 0;
  return finer.cell == CellMethod::cos || finer.method == Method::sampled;
}

std::string_view name(Ending ending) {
  switch (ending) {
    case Ending::done:
      return "done";
    case Ending::timed_out:
      return "timed out";
    case Ending::out_of_memory:
      return "out of memory";
    case Ending::crashed:
      return "crashed";
    case Ending::unavailable:
      return "not available";
    case Ending::failed:
      return "failed";
    case Ending::not_tried:
      return "not tried";
  }
  return "?";
}

Spread spread(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return {(values[(n - 1) / 2] + values[n / 2]) / 2, values.front(), values.back()};
}

namespace {

/// Of the product's engine with this arithmetic, if it has come to an end.
const WayOutcome* ended(const AccuracyReport& report, Arithmetic arithmetic) {
  const auto found = std::find_if(report.outcomes.begin(), report.outcomes.end(), [&](const WayOutcome& o) {
    return o.way.method == Method::exact && o.way.arithmetic == arithmetic && !o.way.plain;
  });
  return found != report.outcomes.end() && found->ending == Ending::done ? &*found : nullptr;
}

}  // namespace

std::optional<Price> price_of_certainty(const AccuracyReport& report) {
  const WayOutcome *chain = ended(report, Arithmetic::chain), *doubles = ended(report, Arithmetic::doubles);
  if (chain == nullptr || doubles == nullptr || !doubles->score) return std::nullopt;
  if (!(doubles->cpu_seconds.median > 0)) return std::nullopt;
  return Price{chain->cpu_seconds.median / doubles->cpu_seconds.median, doubles->score->wrong_in,
               doubles->score->wrong_out};
}

const WayOutcome* usual_sampling(const AccuracyReport& report) {
  constexpr int usual = 6 * 6 * 6;
  const WayOutcome* best = nullptr;
  for (const WayOutcome& o : report.outcomes) {
    if (o.way.method != Method::sampled || o.ending != Ending::done || !o.score) continue;
    if (best == nullptr || best->way.viewpoints != usual) best = &o;
  }
  return best;
}

std::optional<SamplingFigures> sampling_figures(const AccuracyReport& report) {
  constexpr double enough = 0.01;  // of the set may be missed
  const WayOutcome* chain = ended(report, Arithmetic::chain);
  if (chain == nullptr || !(chain->cpu_seconds.median > 0)) return std::nullopt;
  SamplingFigures figures;
  for (const WayOutcome& o : report.outcomes) {
    if (o.way.viewpoints == 0 || o.ending != Ending::done || !o.score) continue;
    if (figures.best == nullptr || figures.best->score->set_missed > enough) figures.best = &o;
    if (o.cpu_seconds.median <= chain->cpu_seconds.median) figures.equal_time = &o;
  }
  if (figures.best == nullptr) return std::nullopt;
  figures.cpu_ratio = figures.best->cpu_seconds.median / chain->cpu_seconds.median;
  return figures;
}

}  // namespace provis
