#pragma once
// Affine maps of glTF nodes: the loading arithmetic of R1, in float64, in a fixed order.

#include <array>
#include <optional>
#include <vector>

#include "predicates/sign.hpp"
#include "provis/vec3.hpp"

namespace provis {

/// Rows of a 3x4 matrix; the fourth row is (0, 0, 0, 1).
struct Placement {
  std::array<std::array<double, 4>, 3> rows{{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

  bool finite() const;
};

/// From translation, rotation (x, y, z, w, as stored) and scale; an empty list is the default.
Placement from_trs(const std::vector<double>& translation, const std::vector<double>& rotation,
                   const std::vector<double>& scale);

/// From glTF's 16 numbers, column by column, the last row left out.
Placement from_columns(const std::vector<double>& matrix);

/// parent * local; every entry is ((p0 l0 + p1 l1) + p2 l2), plus p3 in the last column.
Placement compose(const Placement& parent, const Placement& local);

/// x = ((m00 x + m01 y) + m02 z) + m03, no fused operations.
inline Vec3d apply(const Placement& m, const Vec3d& p) {
  const auto row = [&p](const std::array<double, 4>& r) {
    return ((r[0] * p.x + r[1] * p.y) + r[2] * p.z) + r[3];
  };
  return {row(m.rows[0]), row(m.rows[1]), row(m.rows[2])};
}

/// By how much lengths grow, in all directions alike; nothing where a ball would become an ellipsoid.
///
/// Returns:    the first column's length, sqrt((m00 m00 + m10 m10) + m20 m20); infinite on overflow
/// Error:      the columns' squared lengths and their scalar products may be off by 2^-20 of the largest
///             squared length
std::optional<double> uniform_scale(const Placement& m);

/// The sign of the linear part's determinant.
///
/// Guarantee:  exact for the float64 numbers of the matrix
/// Requires:   finite entries
Sign determinant_sign(const Placement& m);

}  // namespace provis
