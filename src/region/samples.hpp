#pragma once
// Samples of the camera offset space: one direction from all points of a face at once.

#include <vector>

#include "provis/view.hpp"
#include "src/offset/face.hpp"

namespace provis {

/// A sample as a view: the scene in parallel projection along the direction, through the face's rectangle.
/// Rays start in the plane of the face exactly: the window's coordinates are the space's own.
///
/// Requires:   the direction leads beyond the face
PointView offset_sample_view(const offset::Face& face, const Vec3d& direction);

/// The directions through the centres of a raster's pixels, row by row, of any length; those that lead back
/// behind the face are left out.
///
/// Guarantee:  computed once, in float64, and exact from there on: in the rasters of a hemicube they are the
///             centres themselves; through a window, directions in it that are not further from a centre than
///             rounding explains
std::vector<Vec3d> pixel_directions(const offset::Face& face, const offset::Raster& raster);

/// Directions over the half sphere beyond a face, count^2 of them: slopes whose angles are spread evenly.
std::vector<Vec3d> even_directions(const offset::Face& face, int count);

}  // namespace provis
