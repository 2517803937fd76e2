#pragma once
// Where a from-point query looks from, and in which directions (R8).

#include <string>
#include <vector>

#include "provis/vec3.hpp"

namespace provis {

/// A rectangle on the image plane.
struct Window {
  double x0 = -1, x1 = 1, y0 = -1, y1 = 1;

  friend bool operator==(const Window&, const Window&) = default;
};

/// Three vectors, taken as exact and linearly independent, orthonormal or not, and a window.
struct Frame {
  Vec3d right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
  Window window;

  friend bool operator==(const Frame&, const Frame&) = default;
};

/// The pixels of each frame: what sampled methods call a fragment. Never changes an exact set from a point.
struct PixelGrid {
  int width = 1280, height = 720;
};

enum class Projection {
  pinhole,   ///< rays leave the eye along forward + x right + y up
  parallel,  ///< the eye is at infinity: rays leave eye + x right + y up along forward, at distances > 0
  omni,      ///< the whole sphere of directions: six pinhole frames
};

/// One query: an eye and the frames through which it looks.
struct PointView {
  Vec3d eye;
  Projection projection = Projection::pinhole;
  std::vector<Frame> frames;  ///< one for pinhole and parallel, six for omni
};

/// The camera of a renderer.
struct LookAt {
  Vec3d eye;
  Vec3d direction{0, 0, -1};
  Vec3d up{0, 1, 0};               ///< replaced by (0, 0, -1) if parallel to the direction
  double fovy_degrees = 60;        ///< vertical
  int width = 1280, height = 720;  ///< the aspect; never changes an exact set otherwise
};

/// Builds the vectors once, in float64: forward = dir/|dir|, right = normalise(forward x up),
/// up = right x forward, window [-a h, a h] x [-h, h] with h = tan(fovy/2), a = width/height.
///
/// Guarantee:  none needed: the vectors are recorded in the result and taken as exact from there on
/// Degenerate: up parallel to direction is replaced; a zero or non-finite direction throws
/// Throws:     Error::usage
PointView look_at(const LookAt& camera);

/// The whole sphere of directions as six frames: +x, -x, +y, -y, +z, -z, window [-1, 1]^2 each.
PointView omni(const Vec3d& eye);

/// Throws Error::usage unless every number is finite, every window has positive extent, the vectors
/// of each frame are linearly independent (decided exactly), and the frames fit the projection.
void check(const PointView& view);

}  // namespace provis
