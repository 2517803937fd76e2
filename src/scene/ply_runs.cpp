#include "src/scene/ply_runs.hpp"

#include <limits>

#include "src/scene/failure.hpp"

namespace provis {

void PlyRuns::add(std::uint64_t ids, PlyRowNumber from) {
  constexpr std::uint64_t most = std::numeric_limits<PrimitiveId>::max();
  if (ids > most - next_ || from.row > most) fail_unsupported("primitives", "ids and rows end at 2^32 - 1");
  if (goes_on(ids, from)) {
    runs_.back().count += static_cast<std::uint32_t>(ids);
  } else {
    SourceRange run;
    run.first = static_cast<PrimitiveId>(next_);
    run.count = static_cast<std::uint32_t>(ids);
    run.primitive = static_cast<std::int32_t>(from.element);
    run.element = static_cast<std::uint32_t>(from.row);
    run.per_element = static_cast<std::uint32_t>(ids);
    runs_.push_back(run);
  }
  next_ += ids;
}

bool PlyRuns::goes_on(std::uint64_t ids, PlyRowNumber from) const {
  if (runs_.empty()) return false;
  const SourceRange& last = runs_.back();
  return last.primitive == static_cast<std::int32_t>(from.element) && last.per_element == ids &&
         std::uint64_t{last.element} + last.count / last.per_element == from.row;
}

void PlyRuns::append_to(std::vector<SourceRange>& sources, PrimitiveId first) const {
  sources.insert(sources.end(), runs_.begin(), runs_.end());
  for (auto run = sources.end() - static_cast<std::ptrdiff_t>(runs_.size()); run != sources.end(); ++run)
    run->first += first;
}

}  // namespace provis
