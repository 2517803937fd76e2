#pragma once
// Which ids came from which rows of a PLY file.

#include <cstdint>
#include <vector>

#include "provis/scene.hpp"

namespace provis {

/// Where a row stands.
struct PlyRowNumber {
  std::size_t element;  ///< index in the header
  std::uint64_t row;    ///< among the element's
};

/// Gathers runs of ids from 0 on. Rows that became equally many ids and follow each other are one run; a row
/// that became none ends it.
class PlyRuns {
 public:
  /// ids: how many the row became, at least one. Rows come in the file's order.
  ///
  /// Throws:     Error::unsupported where ids or rows exceed 2^32 - 1
  void add(std::uint64_t ids, PlyRowNumber from);

  /// Appends the runs, with ids from `first` on.
  void append_to(std::vector<SourceRange>& sources, PrimitiveId first) const;

 private:
  bool goes_on(std::uint64_t ids, PlyRowNumber from) const;

  std::vector<SourceRange> runs_;
  std::uint64_t next_ = 0;
};

}  // namespace provis
