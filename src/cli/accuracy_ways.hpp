#pragma once
// The ways in which `provis accuracy` has a query answered.

#include <string>
#include <vector>

#include "src/report/accuracy.hpp"

namespace provis {

/// From a point: every arithmetic policy, then every sampled method, the coarsest grid of samples first.
std::vector<Way> point_ways();

/// Along a segment: every arithmetic policy with both engines, then viewpoints, the fewest first.
std::vector<Way> segment_ways();

/// From a cell: a grid of viewpoints, exact sets from viewpoints, the camera offset space, each the coarsest
/// first; then both bounds by all stages. pixels: of what is sampled.
std::vector<Way> cell_ways(const PixelGrid& pixels);

/// The options by which a child takes the way.
std::vector<std::string> options_of(const Way& way);

}  // namespace provis
