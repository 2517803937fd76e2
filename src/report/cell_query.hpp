#pragma once
// The counters of a cell query by their names in files and summaries.

#include <string>
#include <string_view>
#include <vector>

#include "provis/result_file.hpp"

namespace provis {

struct CellCount {
  std::string_view name;
  std::uint64_t* value;
};

/// All counters that are the same for any number of threads.
std::vector<CellCount> counts_of(CellCounts& counts);

struct CellSeconds {
  std::string_view name;
  double* value;
};

/// What each stage took: wall clock down to "verification", then of all threads.
std::vector<CellSeconds> seconds_of(CellCounts& counts);

/// One counter or time per line.
std::string cell_table(CellCounts counts);

}  // namespace provis
