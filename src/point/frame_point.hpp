#pragma once
// Input points in the coordinates of a frame: where a ray has window coordinates (x, y), it is (x, y, 1).

#include "predicates/approx.hpp"
#include "predicates/formulas.hpp"

namespace provis {

/// A point as seen from the viewpoint: (x w, y w, w) for window coordinates (x, y), w > 0 before the viewer,
/// times the frame's determinant. For an eye at infinity w is that determinant.
struct FramePoint {
  Approx at;         ///< one radius for all three
  double along = 0;  ///< distance along forward times the determinant, within `radius`
};

/// Window coordinates, true within the error.
struct WindowPlace {
  double x = 0, y = 0, error = HUGE_VAL;
};

/// The error is infinite for a point that is not certainly before the viewer.
inline WindowPlace window_place(const FramePoint& p) {
  const double w = p.at.v.z, x = p.at.v.x / w, y = p.at.v.y / w;
  // Numerator and denominator are off by a radius each, and the quotient is rounded (ERRORS.md, 7).
  const double error = (2 * p.at.radius * (1 + std::fabs(x) + std::fabs(y))) / w +
                       4 * unit_roundoff * (std::fabs(x) + std::fabs(y));
  return {x, y, w > 4 * p.at.radius && w > 0x1p-300 && error < size_bound ? error : HUGE_VAL};
}

/// The projection to frame coordinates, in plain float64 with a certified bound.
class FrameProjection {
 public:
  explicit FrameProjection(const ViewGeometry& geometry);

  FramePoint operator()(const Vec3d& p) const;

  /// Positive, and not too large or small for float64.
  bool usable() const { return usable_; }
  const Ball& determinant() const { return determinant_; }
  bool at_infinity() const { return at_infinity_; }

 private:
  Vec3d eye_, row_x_, row_y_, row_w_;
  Ball determinant_;
  double error_ = 0;  ///< of a row's product, per largest coordinate of the point seen from the eye
  bool at_infinity_, usable_;
};

}  // namespace provis
