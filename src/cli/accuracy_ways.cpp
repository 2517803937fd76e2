#include "src/cli/accuracy_ways.hpp"

#include "src/report/names.hpp"

namespace provis {

namespace {

constexpr int finest_samples = 256, most_viewpoints = 100'000;

constexpr Arithmetic policies[] = {Arithmetic::doubles, Arithmetic::chain, Arithmetic::mpfr,
                                   Arithmetic::exact};

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

std::vector<std::string> options_of(const Way& way) {
  if (way.viewpoints > 0) return {"--method", "sampled", "--viewpoints", std::to_string(way.viewpoints)};
  std::vector<std::string> words = {"--arithmetic", std::string(name(way.arithmetic))};
  if (way.plain) words.insert(words.end(), {"--engine", "plain"});
  if (way.method == Method::aggressive) words.insert(words.end(), {"--method", "aggressive"});
  if (way.method == Method::sampled)
    words.insert(words.end(), {"--method", "sampled", "--samples", std::to_string(way.samples)});
  return words;
}

}  // namespace provis
