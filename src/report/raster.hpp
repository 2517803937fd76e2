#pragma once
// The pixels of a frame: maps between world, frame and pixel coordinates, in float64.

#include <array>
#include <span>

#include "provis/view.hpp"

namespace provis {

/// Pixel columns [x0, x1) and rows [y0, y1).
struct PixelBox {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;

  bool empty() const { return x0 >= x1 || y0 >= y1; }
};

/// One frame cut into pixels.
class Raster {
 public:
  /// The frame's vectors must be linearly independent.
  Raster(const Vec3d& eye, Projection projection, const Frame& frame, int width, int height);

  int width() const { return width_; }
  int height() const { return height_; }
  bool parallel() const { return parallel_; }

  /// (a, b, c) with p = eye + a right + b up + c forward.
  Vec3d to_frame(const Vec3d& p) const;
  /// The pixel's centre as (x, y, 1), row 0 on top (R8).
  Vec3d centre(int column, int row) const;
  /// The ray of that pixel in world coordinates; its distances are measured in forward vectors.
  Vec3d ray_origin(const Vec3d& centre) const;
  Vec3d ray_direction(const Vec3d& centre) const;
  /// Window coordinates as fractional pixels: pixel (i, j) spans [i, i + 1) x [j, j + 1).
  std::array<double, 2> to_pixels(double x, double y) const;
  /// A box that holds every pixel that the convex hull of these frame points covers.
  PixelBox box(std::span<const Vec3d> points) const;

 private:
  Vec3d eye_;
  Frame frame_;
  bool parallel_;
  int width_, height_;
  std::array<Vec3d, 3> dual_;
};

}  // namespace provis
