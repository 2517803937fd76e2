#pragma once
// What the guarantee of the aggressive method speaks of, decided slowly and exactly.

#include <vector>

#include "provis/point.hpp"
#include "tests/support/case.hpp"

namespace provis::test {

/// Per triangle: whether it has, in some pixel of some frame, a fragment in which no occluder is nearer
/// anywhere. Shares no code with the engine but the place of the pixels' borders.
std::vector<bool> completely_visible_somewhere(const Case& c, const PixelGrid& grid);

}  // namespace provis::test
