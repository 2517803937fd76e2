#pragma once
// Points in the coordinates of a frame that moves along the path, with one certified margin: which pixels a
// triangle can touch at any time.

#include "predicates/path.hpp"
#include "src/segment/block.hpp"

namespace provis {

/// A point p seen from v has window coordinates x = X/Z, y = Y/Z where X, Y and Z are the products of p - v
/// with three rows; Z is its distance times the frame's determinant, which is positive.
class PathProjection {
 public:
  /// reach: no coordinate of the scene or of the path is larger
  PathProjection(const PathGeometry& path, double reach);

  const Vec3d& row_x() const { return row_x_; }
  const Vec3d& row_y() const { return row_y_; }
  const Vec3d& row_z() const { return row_z_; }
  double determinant() const { return determinant_; }
  /// By what part of itself the product of the last row with a pixel's direction may differ from it.
  double skew() const { return skew_; }
  /// What any product of a row, or of one row less x or y times the last, with a point and with a viewpoint
  /// may be off by in all. Infinite where nothing is known.
  double margin() const { return margin_; }
  Vec3d viewpoint(double t) const;

  /// The pixels of `area` at whose centres a triangle may be hit while t is in the range: rounded outwards,
  /// all of them where it may reach behind the camera in a way that bounds nothing. Width 0 where there are
  /// none.
  PixelRect pixels(const Vec3d& a, const Vec3d& b, const Vec3d& c, const TimeRange& range,
                   const PixelRect& area) const;

 private:
  struct Side {
    double low, high;
  };
  Side reach_of(const double* x, const double* z) const;

  PathGeometry path_;
  Vec3d row_x_, row_y_, row_z_;
  double determinant_ = 0, skew_ = 0, margin_ = HUGE_VAL;
  bool fine_x_ = false, fine_y_ = false;  ///< a pixel is much wider than what rounding does to it
};

}  // namespace provis
