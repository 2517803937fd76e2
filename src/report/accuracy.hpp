#pragma once
// What accuracy costs: one query answered in several ways, side by side.

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "provis/cell.hpp"
#include "provis/point.hpp"
#include "provis/result_file.hpp"
#include "src/report/accuracy_score.hpp"

namespace provis {

/// One way to answer the query.
struct Way {
  Method method = Method::exact;
  Arithmetic arithmetic = Arithmetic::chain;
  int samples = 1;     ///< Method::sampled from a point: samples^2 rays in each pixel; from a cell: samples
                       ///< viewpoints along each axis
  int viewpoints = 0;  ///< Method::sampled along a segment or from a cell: how many. CellMethod::lower: from
                       ///< so many alone, besides corners and middle. Else 0
  bool plain = false;  ///< along a segment: by SegmentEngine::plain
  std::optional<CellMethod> cell = {};  ///< from a cell, of what is not sampled
  PixelGrid pixels{0, 0};  ///< CellMethod::cos: of each raster; Method::sampled from a cell: of each frame

  /// Whether the set is the exact one wherever this way comes to an end.
  bool certain() const { return !cell && method == Method::exact && arithmetic != Arithmetic::doubles; }
  bool from_cell() const { return cell || pixels.width > 0; }
  /// From a cell: whether what is visible is proven, and whether what is hidden is.
  bool proves_visible() const { return cell == CellMethod::lower || cell == CellMethod::bounds; }
  bool proves_hidden() const { return cell == CellMethod::cos || cell == CellMethod::bounds; }
};

/// "sampled 4x4", "sampled 1000" (viewpoints), "aggressive"; from a cell "viewpoints 10", "lower", "cos
/// 25x13", "bounds"; otherwise the arithmetic and, where that is not the usual one, the engine:
/// "chain (plain)".
std::string name(const Way& way);

/// Whether the first does what the second does, in smaller steps: more samples, viewpoints, or pixels.
bool refines(const Way& finer, const Way& coarser);

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
  std::optional<SetScore> score;             ///< against the exact set, or what is known of a cell
  std::optional<SetExcess> excess;           ///< of ways that prove what is hidden
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

/// By all ways together: how many primitives are proven to be visible, and how many are not proven hidden.
struct KnownOfCell {
  std::size_t visible = 0, possible = 0;
};

struct AccuracyReport {
  ResultHeader header;  ///< of the scene and the query; its options are those of loading
  int runs = 1;
  double time_limit = 0;             ///< seconds, for each run
  std::uint64_t memory_limit = 0;    ///< bytes, for each run; 0 for none
  int threads = 0;                   ///< of each run
  std::optional<Way> reference;      ///< whose set is the exact one
  std::optional<KnownOfCell> known;  ///< from a cell
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

/// The way that samples a cell as is usual in papers, from 6^3 viewpoints, or else the finest that ended;
/// null without any. Points into the report.
const WayOutcome* usual_sampling(const AccuracyReport& report);

/// Tables for people; the last lines are the price of certainty, or of a cell how much is known.
std::string accuracy_text(const AccuracyReport& report);

/// JSON of format "provis.accuracy", version 1 (README.md).
void write_accuracy_json(const AccuracyReport& report, std::ostream& out);

/// SVG: shares missed over CPU seconds, both logarithmic.
void write_accuracy_picture(const AccuracyReport& report, std::ostream& out);

}  // namespace provis
