#pragma once
// What one pixel sees along a segment, as a line of JSON.

#include <cstddef>
#include <iosfwd>

#include "provis/segment.hpp"

namespace provis {

/// {"segment": 0, "frame": 0, "column": 3, "row": 5, "sights": [["0/1", "1/3", [17]], ...]}, with a line end.
void write_sights(const PixelSights& pixel, std::size_t segment, std::ostream& out);

}  // namespace provis
