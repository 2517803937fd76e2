#pragma once
// The counters of a cell query by their names in files and summaries.

#include <string_view>
#include <vector>

#include "provis/cell.hpp"

namespace provis {

struct CellCount {
  std::string_view name;
  std::uint64_t* value;
};

/// All counters that are the same for any number of threads.
std::vector<CellCount> counts_of(BoundStats& bounds, OffsetStats& offset);

}  // namespace provis
