#pragma once
// A homogeneous viewpoint with one frame: the plain numbers from which every formula starts.

#include <array>

#include "predicates/sign.hpp"
#include "provis/view.hpp"

namespace provis {

/// A finite eye (e, 1) or an eye at infinity (d, 0), and the three vectors of one frame.
///
/// Rays of a finite eye are directions v, three numbers. Rays of an eye at infinity are points of the
/// window's plane taken along the direction d; they too are three numbers once the coordinate in which d
/// is largest has been sheared away. In both cases a *functional* on those three numbers is a line of the
/// image, and a triangle is the cone of the three projected corners (README.md, "One algebra").
struct ViewGeometry {
  Vec3d eye;  ///< for an eye at infinity the window's origin
  Vec3d right, up, forward;
  bool at_infinity = false;
  /// Orientation of (forward, right, up); never zero.
  Sign handedness = Sign::positive;
  /// Eye at infinity: the two coordinates that stay, and the one that is sheared away.
  std::array<int, 3> axes{0, 1, 2};
  /// Eye at infinity: forward or its opposite, so that its largest coordinate is positive.
  Vec3d shear_direction;
  /// Arithmetic::doubles: every sign is decided exactly too, and counted where it was taken wrongly.
  bool checked = false;
};

/// Throws:     Error::usage if the frame's vectors are linearly dependent (decided exactly)
ViewGeometry make_geometry(const Vec3d& eye, const Frame& frame, bool at_infinity);

}  // namespace provis
