#pragma once
// What accuracy costs: one query answered in several ways, side by side.

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "provis/point.hpp"
#include "provis/result_file.hpp"
#include "src/report/accuracy_score.hpp"

namespace provis {

/// One way to answer the query.
struct Way {
  Method method = Method::exact;
  Arithmetic arithmetic = Arithmetic::chain;
  int samples = 1;     ///< Method::sampled from a point: samples^2 rays in each pixel
  int viewpoints = 0;  ///< Method::sampled along a segment: how many; else 0
  bool plain = false;  ///< along a segment: by SegmentEngine::plain

  /// Whether the set is the exact one wherever this way comes to an end.
  bool certain() const { return method == Method::exact && arithmetic != Arithmetic::doubles; }
};

/// "sampled 4x4", "sampled 1000" (viewpoints), "aggressive", or for Method::exact the arithmetic and, where
/// that is not the usual one, the engine: "chain (plain)".
std::string name(const Way& way);

/// How a run came to its end.
enum class Ending {
  done,
  timed_out,
  out_of_memory,
  crashed,      ///< by a signal, which the reason names
  unavailable,  ///< refused: the reason is the error's text
  failed,       ///< any other error
  not_tried,    ///< the reason says why
};

std::string_view name(Ending ending);

/// Of the runs of one way.
struct Spread {
  double median = 0, least = 0, most = 0;
};

/// Requires: at least one value.
Spread spread(std::vector<double> values);

/// What one way gave, and what it cost.
struct WayOutcome {
  Way way;
  Ending ending = Ending::not_tried;
  std::string reason;
  // Of ways that are done:
  Spread cpu_seconds, wall_seconds, peak_bytes;
  SignCounts signs;
  std::size_t visible = 0;
  std::optional<SetScore> score;             ///< against the exact set, where there is one
  std::optional<std::uint64_t> wrong_signs;  ///< doubles: of a run whose signs were decided exactly too
  std::string unchecked;                     ///< doubles: why they were not
};

/// By what shares of the image are measured.
enum class AreaMeasure {
  sight,        ///< along segments: for how long each visible triangle is seen, summed over pixels
  subdivision,  ///< exact cells: what is seen where
  projection,   ///< of each visible triangle the area of its image, hidden parts too
  none,
};

struct AccuracyReport {
  ResultHeader header;  ///< of the scene and the query; its options are those of loading
  int runs = 1;
  double time_limit = 0;           ///< seconds, for each run
  std::uint64_t memory_limit = 0;  ///< bytes, for each run; 0 for none
  int threads = 0;                 ///< of each run
  std::optional<Way> reference;    ///< whose set is the exact one
  AreaMeasure area = AreaMeasure::none;
  std::string no_subdivision;  ///< why the area is not measured by it
  std::vector<WayOutcome> outcomes;
};

/// What certainty costs over plain doubles.
struct Price {
  double ratio = 0;                         ///< CPU seconds of the chain by those of doubles
  std::size_t wrong_in = 0, wrong_out = 0;  ///< of the set by doubles; both 0 where the sets are the same
};

/// How far sampling has come, along a segment: against the time of the chain.
struct SamplingFigures {
  const WayOutcome* best = nullptr;  ///< the fewest viewpoints that find 99 %, or else the most that ended
  const WayOutcome* equal_time =
      nullptr;           ///< the most viewpoints in no more CPU time; null if not even the fewest
  double cpu_ratio = 0;  ///< of best, by the chain's CPU seconds
};

/// Nothing unless the chain and the fewest viewpoints have come to an end. Points into the report.
std::optional<SamplingFigures> sampling_figures(const AccuracyReport& report);

/// Nothing unless both have come to an end.
std::optional<Price> price_of_certainty(const AccuracyReport& report);

/// Tables for people; the last line is the price of certainty.
std::string accuracy_text(const AccuracyReport& report);

/// JSON of format "provis.accuracy", version 1 (README.md).
void write_accuracy_json(const AccuracyReport& report, std::ostream& out);

/// SVG: shares missed over CPU seconds, both logarithmic.
void write_accuracy_picture(const AccuracyReport& report, std::ostream& out);

}  // namespace provis
