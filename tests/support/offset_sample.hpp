#pragma once
// The camera offset space at its samples, by clipping polygons over rational numbers. Shares no code with the
// engine, nor with the other oracles.

#include <gmpxx.h>

#include <cstdint>
#include <vector>

#include "provis/cell.hpp"

namespace provis::test {

/// What one direction shows of a triangle.
enum class Shown : std::uint8_t {
  nothing,
  on_occluders,  ///< from an open set of the face's points (R10), all of them on occluders in its plane
  proven,        ///< from an open set of points on no occluder (R10°)
};

/// Per triangle, for a direction of any length that leads out of a face of the cell.
std::vector<Shown> offset_sample(const SceneArrays& scene, const ViewCell& cell, int axis, bool upper,
                                 const Vec3<mpq_class>& direction);

/// Per triangle: the most that any sample shows, one at the centre of each pixel of each raster of each face.
std::vector<Shown> offset_samples(const SceneArrays& scene, const ViewCell& cell, const PixelGrid& pixels);

}  // namespace provis::test
