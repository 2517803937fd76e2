#pragma once
// A result as text for people.

#include <array>
#include <map>
#include <string>

#include "provis/result_file.hpp"

namespace provis {

/// About ten lines: the scene, the query, the counts, what is claimed and what it cost.
std::string summary(const ResultFile& result);

/// "pinhole from 0,1.8,0 along 1,0,0, window ...".
std::string query_text(const PointView& view);

/// "segment from 0,1.8,0 to 5,1.8,0, 6 frames of 800x800 pixels".
std::string query_text(const SegmentQuery& segments);

/// "cell from -0.15,1.65,-0.15 to 0.15,1.95,0.15".
std::string query_text(const ViewCell& cell);

/// Of whichever kind it is.
std::string query_text(const ResultHeader& header);

/// The counts of all predicates, by tier.
std::array<std::uint64_t, tier_count> by_tier(const SignCounts& signs);

/// One row per predicate, one column per tier: how often each decided.
std::string sign_table(const SignCounts& signs);

/// What the sampled methods and the paper's engine count: a line per figure, none where there is nothing.
std::string sampling_text(const QueryStats& stats);

/// "memory  12.3 MiB at the peak, beyond the scene"; nothing where it was not measured.
std::string memory_text(const QueryStats& stats);

/// "perturb 0, seed 0, sides material".
std::string options_text(const std::map<std::string, std::string>& options);

}  // namespace provis
