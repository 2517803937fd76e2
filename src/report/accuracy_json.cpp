// "provis.accuracy": every number of the report; null stands where there is none.

#include <ostream>

#include "src/report/accuracy.hpp"
#include "src/report/json_text.hpp"
#include "src/report/query_json.hpp"
#include "src/report/summary.hpp"

namespace provis {

namespace {

using Json = nlohmann::ordered_json;

Json json(const Spread& s) { return {{"median", s.median}, {"least", s.least}, {"most", s.most}}; }

Json text_or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

std::string_view family(const Way& way) {
  if (way.cell)
    return way.cell == CellMethod::lower ? "lower" : way.cell == CellMethod::cos ? "cos" : "bounds";
  return way.method == Method::sampled      ? "sampled"
         : way.method == Method::aggressive ? "aggressive"
                                            : "exact";
}

Json signs(const WayOutcome& o) {
  const auto sums = by_tier(o.signs);
  Json row = Json::object();
  for (int t = 0; t < tier_count; ++t)
    row[std::string(name(static_cast<Tier>(t)))] = sums[static_cast<std::size_t>(t)];
  row["wrong"] = o.wrong_signs ? Json(*o.wrong_signs) : Json();
  return row;
}

Json json(const SetScore& score, bool area) {
  return {{"wrong_in", score.wrong_in},
          {"wrong_out", score.wrong_out},
          {"set_missed", score.set_missed},
          {"area_missed", area ? Json(score.area_missed) : Json()}};
}

Json json(const SetExcess& e) { return {{"possible", e.possible}, {"beyond", e.beyond}, {"share", e.share}}; }

Json json(const WayOutcome& o, bool area) {
  Json row = {
      {"name", name(o.way)},
      {"method", family(o.way)},
      {"arithmetic", name(o.way.arithmetic)},
      {"samples", o.way.method == Method::sampled && o.way.viewpoints == 0 ? Json(o.way.samples) : Json()},
      {"ending", name(o.ending)},
      {"reason", text_or_null(o.reason)}};
  if (o.way.viewpoints > 0) row["viewpoints"] = o.way.viewpoints;
  if (o.way.pixels.width > 0) row["pixels"] = {o.way.pixels.width, o.way.pixels.height};
  if (o.way.plain) row["engine"] = "plain";
  if (o.ending != Ending::done) return row;
  row["cpu_seconds"] = json(o.cpu_seconds);
  row["wall_seconds"] = json(o.wall_seconds);
  row["peak_bytes"] = json(o.peak_bytes);
  row["visible"] = o.visible;
  row["score"] = o.score ? json(*o.score, area) : Json();
  if (o.excess) row["excess"] = json(*o.excess);
  row["signs"] = signs(o);
  row["unchecked"] = text_or_null(o.unchecked);
  return row;
}

Json area(const AccuracyReport& report) {
  const Json measure = report.area == AreaMeasure::sight         ? Json("sight")
                       : report.area == AreaMeasure::subdivision ? Json("subdivision")
                       : report.area == AreaMeasure::projection  ? Json("projection")
                                                                 : Json();
  return {{"measure", measure}, {"no_subdivision", text_or_null(report.no_subdivision)}};
}

Json price(const AccuracyReport& report) {
  const std::optional<Price> price = price_of_certainty(report);
  if (!price) return Json();
  return {{"cpu_ratio", price->ratio}, {"wrong_in", price->wrong_in}, {"wrong_out", price->wrong_out}};
}

Json members(const AccuracyReport& report) {
  Json root = {{"program", {{"name", "provis"}, {"version", PROVIS_VERSION}}}};
  root["scene"] = scene_json(report.header);
  root["query"] = query_json(report.header);
  root["runs"] = report.runs;
  root["threads"] = report.threads;
  root["limits"] = {{"seconds", report.time_limit},
                    {"bytes", report.memory_limit == 0 ? Json() : Json(report.memory_limit)}};
  root["exact_set_by"] = report.reference ? Json(name(*report.reference)) : Json();
  if (report.header.cell)
    root["known"] = report.known
                        ? Json{{"visible", report.known->visible}, {"possible", report.known->possible}}
                        : Json();
  root["area"] = area(report);
  root["ways"] = Json::array();
  for (const WayOutcome& o : report.outcomes)
    root["ways"].push_back(json(o, report.area != AreaMeasure::none));
  root["certainty"] = price(report);
  return root;
}

}  // namespace

void write_accuracy_json(const AccuracyReport& report, std::ostream& out) {
  out << "{\"format\": \"provis.accuracy\",\n\"version\": 1";
  const Json all = members(report);
  for (const auto& [key, value] : all.items()) {
    if (key == "ways") continue;
    out << ",\n\"" << key << "\": " << json_text(value);
  }
  out << ",\n\"ways\": [";
  const char* separator = "\n";
  for (const Json& way : all.at("ways")) {
    out << separator << json_text(way);
    separator = ",\n";
  }
  out << "]}\n";
}

}  // namespace provis
