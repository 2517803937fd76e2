#include "provis/result_file.hpp"

namespace provis {

PointView SegmentQuery::first_view() const {
  constexpr std::size_t sphere = 6;
  if (paths.empty() || frames.empty()) return {};
  const std::size_t n = frames.size() >= sphere ? sphere : 1;
  return {paths.front().from,
          n == sphere ? Projection::omni : Projection::pinhole,
          {frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(n)}};
}

}  // namespace provis
