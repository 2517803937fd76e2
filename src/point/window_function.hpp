#pragma once
// Affine functions of window coordinates, each with one certified error: what rays and whole rectangles are
// judged by before a sign is asked for.

#include <algorithm>
#include <cmath>

#include "src/point/frame_point.hpp"

namespace provis {

/// The largest |x| and |y| of a window's rays.
struct WindowExtent {
  double x = 0, y = 0;

  explicit WindowExtent(const Window& w)
      : x(std::max(std::fabs(w.x0), std::fabs(w.x1))), y(std::max(std::fabs(w.y0), std::fabs(w.y1))) {}

  double of(double a, double b, double c) const { return std::fabs(a) * x + std::fabs(b) * y + std::fabs(c); }
};

inline bool overlap(const Window& a, const Window& b) {
  return a.x0 <= b.x1 && b.x0 <= a.x1 && a.y0 <= b.y1 && b.y0 <= a.y1;
}

inline Window intersection(const Window& a, const Window& b) {
  return {std::max(a.x0, b.x0), std::min(a.x1, b.x1), std::max(a.y0, b.y0), std::min(a.y1, b.y1)};
}

/// a x + b y + c lies within `error` of the true value on every ray of the window, and so does each value
/// below. Where nothing is known the error is infinite and the coefficients are zero: a coefficient that
/// overflowed would make the bounds NaN, and a least bound that is taken over several could lose it.
struct WindowFunction {
  double a = 0, b = 0, c = 0, error = HUGE_VAL;

  double at(double x, double y) const { return (a * x + b * y) + c; }
  double lowest(const Window& w) const {
    return (a * (a > 0 ? w.x0 : w.x1) + b * (b > 0 ? w.y0 : w.y1)) + c - error;
  }
  double highest(const Window& w) const {
    return (a * (a > 0 ? w.x1 : w.x0) + b * (b > 0 ? w.y1 : w.y0)) + c + error;
  }
};

/// f - g.
inline WindowFunction difference(const WindowFunction& f, const WindowFunction& g) {
  // Each has paid for its own evaluation; the difference of coefficients loses no more (ERRORS.md, 6).
  return {f.a - g.a, f.b - g.b, f.c - g.c, (f.error + g.error) * (1 + 0x1p-20)};
}

/// What evaluation loses: two products and three sums of magnitudes that add up to the size (ERRORS.md, 6).
inline double evaluation_error(double size) { return 8 * unit_roundoff * size; }

/// From coefficients with one radius.
inline WindowFunction window_function(const Vec3d& v, double radius, const WindowExtent& extent) {
  const double size = extent.of(v.x, v.y, v.z);
  const double reach = extent.x + extent.y + 1;
  const double error = (radius * reach + evaluation_error(size)) * (1 + 0x1p-20) + underflow_bound;
  if (!(size + error < size_bound && reach < size_bound)) return {};
  return {v.x, v.y, v.z, error};
}

/// Positive to the left of the way from a to b in the window (y upwards).
inline WindowFunction edge_function(const FramePoint& a, const FramePoint& b, const WindowExtent& extent) {
  const Approx line = cross(a.at, b.at);
  return window_function(line.v, line.radius, extent);
}

/// The depth of a plane times at_eye: growing towards the viewer if at_eye > 0.
inline WindowFunction depth_numerator(const ViewGeometry& g, const Plane<Ball>& plane,
                                      const WindowExtent& extent) {
  const Ball a = dot(plane.normal, numbers<Ball>(g.right)), b = dot(plane.normal, numbers<Ball>(g.up));
  const Ball c = g.at_infinity ? plane.offset : dot(plane.normal, numbers<Ball>(g.forward));
  return window_function({a.value, b.value, c.value}, std::max({a.radius, b.radius, c.radius}), extent);
}

/// The depth itself. Requires: at_eye > 0.
inline WindowFunction depth_function(const ViewGeometry& g, const Plane<Ball>& plane,
                                     const WindowExtent& extent) {
  const WindowFunction n = depth_numerator(g, plane, extent);
  const double d = plane.at_eye.value, least = d - plane.at_eye.radius;
  const double a = n.a / d, b = n.b / d, c = n.c / d;
  const double size = extent.of(a, b, c);
  // What the numerator is off by, what the denominator is, and the divisions (ERRORS.md, 6).
  const double error =
      ((n.error + size * plane.at_eye.radius) / least + evaluation_error(size) + 2 * unit_roundoff * size) *
          (1 + 0x1p-20) +
      underflow_bound;
  if (!(least > 0x1p-900 && size + error < size_bound)) return {};
  return {a, b, c, error};
}

}  // namespace provis
