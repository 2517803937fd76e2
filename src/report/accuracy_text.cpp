// The report for people: what was asked, what each way cost and gave, the signs behind it, and the price.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

#include "src/report/accuracy.hpp"
#include "src/report/summary.hpp"

namespace provis {

namespace {

using Out = std::back_insert_iterator<std::string>;

constexpr double mebibyte = 1 << 20;

/// Three significant digits, and no exponent for anything a stopwatch can show.
std::string seconds(double value) {
  const int decimals = value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3;
  return fmt::format("{:.{}f}", value, decimals);
}

/// "0" is exactly nothing.
std::string percent(double share) { return share == 0 ? "0" : fmt::format("{:.3g} %", 100 * share); }

std::string because(const WayOutcome& o) { return o.reason.empty() ? "" : ": " + o.reason; }

void add_known(Out out, const AccuracyReport& report) {
  if (!report.known) {
    fmt::format_to(out, "known      nothing: no way that proves anything ended\n");
    return;
  }
  const auto& [visible, possible] = *report.known;
  fmt::format_to(out,
                 "known      by all proofs together {} are visible, and {} are hidden; {} may be either\n",
                 visible, report.header.triangles - possible, possible - visible);
}

/// By what the ways are judged.
void add_truth(Out out, const AccuracyReport& report) {
  if (report.header.cell) {
    add_known(out, report);
    return;
  }
  fmt::format_to(
      out, "exact set  {}\n",
      report.reference ? "by " + name(*report.reference) : std::string("not known: nothing certain ended"));
  switch (report.area) {
    case AreaMeasure::sight:
      fmt::format_to(
          out, "sight      pixels x time: each triangle counts by how long it is seen at how many pixels\n");
      break;
    case AreaMeasure::subdivision:
      fmt::format_to(out, "area       shares of the window, by the exact subdivision\n");
      break;
    case AreaMeasure::projection:
      fmt::format_to(
          out,
          "area       not that of the image: the subdivision {}. Instead each visible triangle counts\n"
          "           with its projected area in the window, hidden parts included\n",
          report.no_subdivision);
      break;
    case AreaMeasure::none:
      fmt::format_to(out, "area       not measured\n");
      break;
  }
}

void add_heading(Out out, const AccuracyReport& report) {
  const ResultHeader& header = report.header;
  fmt::format_to(out, "scene      {} ({} triangles, {} spheres)\n", header.scene_file, header.triangles,
                 header.spheres);
  fmt::format_to(out, "hash       {}\n", header.scene_hash);
  fmt::format_to(out, "query      {}\n", query_text(header));
  fmt::format_to(out, "options    {}\n", options_text(header.options));
  fmt::format_to(out, "runs       {} of each way on {} threads; at most {:g} s and {}\n", report.runs,
                 report.threads, report.time_limit,
                 report.memory_limit == 0
                     ? std::string("any memory")
                     : fmt::format("{:.0f} MiB", static_cast<double>(report.memory_limit) / mebibyte));
  add_truth(out, report);
}

/// What each way gave, after what it cost: headings.
std::vector<std::string> columns(const AccuracyReport& report) {
  if (report.header.cell)
    return {"visible", "wrong in", "wrong out", "missed", "not hidden", "too many", "beyond"};
  return {"visible", "wrong in", "wrong out", "set missed",
          report.area == AreaMeasure::sight ? "sight missed" : "area missed"};
}

std::vector<std::string> values(const WayOutcome& o, const AccuracyReport& report) {
  const auto number = [](std::size_t n) { return std::to_string(n); };
  if (report.header.cell) {
    std::vector<std::string> row(7, "-");
    if (o.score) {
      row[0] = number(o.visible);
      row[1] = number(o.score->wrong_in);
      row[2] = number(o.score->wrong_out);
      row[3] = percent(o.score->set_missed);
    }
    if (o.excess) {
      row[4] = number(o.excess->possible);
      row[5] = number(o.excess->beyond);
      row[6] = percent(o.excess->share);
    }
    return row;
  }
  if (!o.score) return {number(o.visible), "?", "?", "?", "?"};
  return {number(o.visible), number(o.score->wrong_in), number(o.score->wrong_out),
          percent(o.score->set_missed), percent(o.score->area_missed)};
}

void add_costs(Out out, const AccuracyReport& report) {
  fmt::format_to(out, "\n{:<15}{:>8}{:>17}{:>9}{:>9}", "way", "CPU s", "least to most", "wall s", "MiB");
  const std::vector<std::string> headings = columns(report);
  const auto width = [&](std::size_t k) { return std::max<std::size_t>(10, headings[k].size() + 2); };
  for (std::size_t k = 0; k < headings.size(); ++k) fmt::format_to(out, "{:>{}}", headings[k], width(k));
  fmt::format_to(out, "\n");
  for (const WayOutcome& o : report.outcomes) {
    fmt::format_to(out, "{:<15}", name(o.way));
    if (o.ending != Ending::done) {
      fmt::format_to(out, "  {}{}\n", name(o.ending), because(o));
      continue;
    }
    fmt::format_to(out, "{:>8}{:>17}{:>9}{:>9.1f}", seconds(o.cpu_seconds.median),
                   seconds(o.cpu_seconds.least) + " to " + seconds(o.cpu_seconds.most),
                   seconds(o.wall_seconds.median), o.peak_bytes.median / mebibyte);
    const std::vector<std::string> row = values(o, report);
    for (std::size_t k = 0; k < row.size(); ++k) fmt::format_to(out, "{:>{}}", row[k], width(k));
    fmt::format_to(out, "\n");
  }
}

/// Signs that were taken wrongly. Certain ways take none, of doubles it is known if they were checked, and a
/// grid of samples claims nothing.
std::string wrong_text(const WayOutcome& o) {
  if (o.way.method == Method::sampled) return "-";
  if (o.way.arithmetic != Arithmetic::doubles) return "0";
  if (o.way.plain) return "-";
  return o.wrong_signs ? fmt::format("{}", *o.wrong_signs) : "?";
}

void add_signs(Out out, const AccuracyReport& report) {
  fmt::format_to(out, "\n{:<15}{:>14}", "signs", "all");
  for (int t = 0; t < tier_count; ++t) fmt::format_to(out, "{:>13}", name(static_cast<Tier>(t)));
  fmt::format_to(out, "{:>10}\n", "wrong");
  for (const WayOutcome& o : report.outcomes) {
    if (o.ending != Ending::done) continue;
    const auto sums = by_tier(o.signs);
    const std::uint64_t all = std::accumulate(sums.begin(), sums.end(), std::uint64_t{0});
    if (all == 0) continue;
    fmt::format_to(out, "{:<15}{:>14}", name(o.way), all);
    for (const std::uint64_t sum : sums) fmt::format_to(out, "{:>13}", sum);
    fmt::format_to(out, "{:>10}\n", wrong_text(o));
  }
  for (const WayOutcome& o : report.outcomes)
    if (!o.unchecked.empty())
      fmt::format_to(out, "wrong signs of {} were not counted: {}\n", name(o.way), o.unchecked);
}

std::string price_text(const AccuracyReport& report) {
  const std::optional<Price> price = price_of_certainty(report);
  if (!price) return "not known: the chain or doubles did not end";
  if (price->wrong_in == 0 && price->wrong_out == 0)
    return fmt::format("{:.2f} times the CPU time of plain doubles, which gave the same set", price->ratio);
  return fmt::format("doubles gave another set ({} in, {} out); {:.2f} times its CPU time", price->wrong_in,
                     price->wrong_out, price->ratio);
}

void add_sampling(Out out, const AccuracyReport& report) {
  const std::optional<SamplingFigures> figures = sampling_figures(report);
  if (!figures) return;
  const auto found = [](const WayOutcome& o) {
    return fmt::format("{:.4g} % of the set from {} viewpoints", 100 * (1 - o.score->set_missed),
                       o.way.viewpoints);
  };
  fmt::format_to(out, "sampling   {}, in {:.3g} times the CPU time of the chain\n", found(*figures->best),
                 figures->cpu_ratio);
  fmt::format_to(
      out, "           {} in no more time than the chain\n",
      figures->equal_time != nullptr ? found(*figures->equal_time) : "not even the fewest viewpoints");
}

void add_cell(Out out, const AccuracyReport& report) {
  if (!report.known) return;
  const auto& [visible, possible] = *report.known;
  if (visible > 0)
    fmt::format_to(out, "\nbounds     what is not proven hidden is {:.3f} times what is proven visible\n",
                   static_cast<double>(possible) / static_cast<double>(visible));
  if (const WayOutcome* o = usual_sampling(report))
    fmt::format_to(out, "sampling   {} viewpoints miss {} of what is proven visible, {} in number\n",
                   o->way.viewpoints, percent(o->score->set_missed), o->score->wrong_out);
}

}  // namespace

std::string accuracy_text(const AccuracyReport& report) {
  std::string text;
  const Out out(text);
  add_heading(out, report);
  add_costs(out, report);
  add_signs(out, report);
  if (report.header.cell) {
    add_cell(out, report);
  } else {
    fmt::format_to(out, "\ncertainty  {}\n", price_text(report));
    add_sampling(out, report);
  }
  return text;
}

}  // namespace provis
