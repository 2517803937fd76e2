#pragma once
// The faces of a view cell, each with the rasters through which is looked outward from it.

#include <array>
#include <vector>

#include "provis/cell.hpp"

namespace provis::offset {

/// A rectangle of camera offsets in the plane axis = height; looked at is what lies beyond it.
struct Face {
  int axis = 0;
  bool upper = true;  ///< looks along +axis
  double height = 0;
  std::array<Vec3d, 4> corners;  ///< of the rectangle, going round; equal where the cell is flat

  /// The part of the rectangle from share 0 to 1/2 (or 1/2 to 1) along one of its two edges; the same face
  /// where float64 knows no number between.
  Face half(int edge, bool upper_half) const;

  /// How far a point lies beyond the face's plane, rounded; the sign is exact.
  double beyond(const Vec3d& p) const;
};

/// A rectangle of directions forward + x right + y up, in pixels.
struct Raster {
  Frame frame;
  std::vector<double> columns, rows;  ///< the borders of pixels: neighbours share these very numbers
};

/// The faces from which rays leave the cell; for a flat cell the two sides of its plane.
///
/// Guarantee:  almost every ray that starts in the cell leaves it through one of these faces
std::vector<Face> faces_of(const ViewCell& cell);

/// The rasters of one face: of the window where there is one, otherwise the five of a hemicube.
///
/// Guarantee:  almost every direction that leads beyond the face belongs to a raster's closed window
std::vector<Raster> rasters_of(const ViewCell& cell, const Face& face, const PixelGrid& pixels);

}  // namespace provis::offset
