#include "src/report/accuracy.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace provis {

std::string name(const Way& way) {
  switch (way.method) {
    case Method::sampled:
      return fmt::format("sampled {0}x{0}", way.samples);
    case Method::aggressive:
      return "aggressive";
    case Method::exact:
      break;
  }
  return std::string(name(way.arithmetic));
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

std::optional<Price> price_of_certainty(const AccuracyReport& report) {
  const auto outcome = [&](Arithmetic arithmetic) -> const WayOutcome* {
    const auto found = std::find_if(report.outcomes.begin(), report.outcomes.end(), [&](const WayOutcome& o) {
      return o.way.method == Method::exact && o.way.arithmetic == arithmetic;
    });
    return found != report.outcomes.end() && found->ending == Ending::done ? &*found : nullptr;
  };
  const WayOutcome *chain = outcome(Arithmetic::chain), *doubles = outcome(Arithmetic::doubles);
  if (chain == nullptr || doubles == nullptr || !doubles->score) return std::nullopt;
  if (!(doubles->cpu_seconds.median > 0)) return std::nullopt;
  return Price{chain->cpu_seconds.median / doubles->cpu_seconds.median, doubles->score->wrong_in,
               doubles->score->wrong_out};
}

}  // namespace provis
