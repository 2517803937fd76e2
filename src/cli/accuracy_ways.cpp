#include "src/cli/accuracy_ways.hpp"

#include <fmt/format.h>

#include "src/report/names.hpp"

namespace provis {

namespace {

constexpr int finest_samples = 256, most_viewpoints = 100'000, most_exact_viewpoints = 1000;

constexpr Arithmetic policies[] = {Arithmetic::doubles, Arithmetic::chain, Arithmetic::mpfr,
                                   Arithmetic::exact};

std::vector<std::string> options_of_cell(const Way& way) {
  const std::string pixels = fmt::format("{}x{}", way.pixels.width, way.pixels.height);
  if (!way.cell) return {"--method", "sampled", "--grid", std::to_string(way.samples), "--size", pixels};
  if (way.cell == CellMethod::bounds) return {"--method", "bounds"};
  if (way.cell == CellMethod::cos) return {"--method", "cos", "--cos-size", pixels};
  std::vector<std::string> words = {"--method", "lower"};
  if (way.viewpoints > 0)
    words.insert(words.end(),
                 {"--viewpoints", std::to_string(way.viewpoints), "--path-pixels", "0", "--directions", "0"});
  return words;
}

}  // namespace

std::vector<Way> point_ways() {
  std::vector<Way> ways;
  for (const Arithmetic a : policies) ways.push_back({Method::exact, a});
  ways.push_back({Method::aggressive});
  for (int samples = 1; samples <= finest_samples; samples *= 2)
    ways.push_back({Method::sampled, Arithmetic::chain, samples});
  return ways;
}

std::vector<Way> segment_ways() {
  std::vector<Way> ways;
  for (const bool plain : {false, true})
    for (const Arithmetic a : policies) ways.push_back({Method::exact, a, 1, 0, plain});
  for (int viewpoints = 10; viewpoints <= most_viewpoints; viewpoints *= 10)
    ways.push_back({Method::sampled, Arithmetic::doubles, 1, viewpoints});
  return ways;
}

std::vector<Way> cell_ways(const PixelGrid& pixels) {
  std::vector<Way> ways;
  for (const int per_axis : {2, 4, 6, 10})
    ways.push_back(
        {Method::sampled, Arithmetic::doubles, per_axis, per_axis * per_axis * per_axis, false, {}, pixels});
  for (int viewpoints = 1; viewpoints <= most_exact_viewpoints; viewpoints *= 10)
    ways.push_back({Method::exact, Arithmetic::chain, 1, viewpoints, false, CellMethod::lower});
  ways.push_back({Method::exact, Arithmetic::chain, 1, 0, false, CellMethod::lower});
  for (const PixelGrid& raster : {PixelGrid{25, 13}, {50, 25}, {100, 50}, {200, 100}, {400, 200}})
    ways.push_back({Method::exact, Arithmetic::chain, 1, 0, false, CellMethod::cos, raster});
  ways.push_back({Method::exact, Arithmetic::chain, 1, 0, false, CellMethod::bounds});
  return ways;
}

std::vector<std::string> options_of(const Way& way) {
  if (way.from_cell()) return options_of_cell(way);
  if (way.viewpoints > 0) return {"--method", "sampled", "--viewpoints", std::to_string(way.viewpoints)};
  std::vector<std::string> words = {"--arithmetic", std::string(name(way.arithmetic))};
  if (way.plain) words.insert(words.end(), {"--engine", "plain"});
  if (way.method == Method::aggressive) words.insert(words.end(), {"--method", "aggressive"});
  if (way.method == Method::sampled)
    words.insert(words.end(), {"--method", "sampled", "--samples", std::to_string(way.samples)});
  return words;
}

}  // namespace provis
