#pragma once
// The camera offset space at one sample, by clipping polygons over rational numbers. Shares no code with the
// engine, nor with the other oracles.

#include <vector>

#include "provis/cell.hpp"

namespace provis::test {

/// Per triangle: whether it is visible along the direction (along the axis, outward: 1; along the next two
/// axes: x and y) from an open set of the points of a face (R10, on interiors).
std::vector<bool> offset_sample(const SceneArrays& scene, const ViewCell& cell, int axis, bool upper,
                                double x, double y);

}  // namespace provis::test
