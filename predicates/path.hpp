#pragma once
// A pixel's centre on a camera that translates: everything about it is linear in time, or a quotient of such.

#include <cstdint>

#include "predicates/line.hpp"
#include "provis/view.hpp"

namespace provis {

/// A path from `from` to `to`, t in [0, 1], and one frame that goes along without turning.
struct PathGeometry {
  Vec3d from, to;
  Frame frame;
  PixelGrid pixels;
  /// Arithmetic::doubles: every sign is decided exactly too, and counted where it was taken wrongly.
  bool checked = false;
};

/// Column and row of a pixel, row 0 on top.
struct Pixel {
  int column = 0, row = 0;
};

/// A function of time, value(t) = at_zero - t slope; its root is an event, at_zero / slope.
template <class N>
struct Linear {
  N at_zero, slope;
};

enum class MotionKind : std::uint8_t { time, edge, reach, depth };

/// The definition of a function that is linear in time. It is over triangles of the scene, and of one pixel.
struct Motion {
  MotionKind kind = MotionKind::time;
  double time = 0;        ///< time: where the root is
  Corners first, second;  ///< edge: from first.p[0] to first.p[1]; reach: first; depth: both
};

/// The direction through a pixel's centre times 4 W H, which clears the centre of its denominators (R8).
/// Degree 1 in lengths, 1 in window coordinates; the weights are integers below 2^31.
template <class N>
Vec3<N> pixel_direction(const PathGeometry& g, const Pixel& at) {
  const Window& w = g.frame.window;
  const double width = 2.0 * g.pixels.width, height = 2.0 * g.pixels.height;
  const double i = 2.0 * at.column + 1, j = 2.0 * at.row + 1;
  const N x = N(width - i) * N(w.x0) + N(i) * N(w.x1);
  const N y = N(height - j) * N(w.y1) + N(j) * N(w.y0);
  return N(width * height) * numbers<N>(g.frame.forward) + (N(height) * x) * numbers<N>(g.frame.right) +
         (N(width) * y) * numbers<N>(g.frame.up);
}

/// Whether rays meet the triangle's front (negative), its back, or run along its plane. Degree 3.
template <class N>
N along(const PathGeometry& g, const Pixel& at, const Corners& t) {
  const Vec3<N> o = numbers<N>(*t.p[0]);
  return dot(cross(numbers<N>(*t.p[1]) - o, numbers<N>(*t.p[2]) - o), pixel_direction<N>(g, at));
}

/// det[d, a - v(t), b - v(t)]: the side of the edge from a to b on which the ray passes. Degree 3.
template <class N>
Linear<N> edge_motion(const PathGeometry& g, const Pixel& at, const Vec3d& a, const Vec3d& b) {
  const Vec3<N> o = numbers<N>(g.from), step = numbers<N>(g.to) - o, e = numbers<N>(b) - numbers<N>(a);
  const Vec3<N> d = pixel_direction<N>(g, at);
  return {dot(cross(numbers<N>(a) - o, e), d), dot(cross(step, e), d)};
}

/// n . (a - v(t)): how far the plane is along its normal n. Degree 3.
template <class N>
Linear<N> reach_motion(const PathGeometry& g, const Corners& t) {
  const Vec3<N> a = numbers<N>(*t.p[0]), o = numbers<N>(g.from);
  const Vec3<N> n = cross(numbers<N>(*t.p[1]) - a, numbers<N>(*t.p[2]) - a);
  return {dot(n, a - o), dot(n, numbers<N>(g.to) - o)};
}

/// The distance of the first plane less that of the second, times both values of `along`. Degree 6.
template <class N>
Linear<N> depth_motion(const PathGeometry& g, const Pixel& at, const Corners& first, const Corners& second) {
  const Linear<N> r1 = reach_motion<N>(g, first), r2 = reach_motion<N>(g, second);
  const N n1 = along<N>(g, at, first), n2 = along<N>(g, at, second);
  return {r1.at_zero * n2 - r2.at_zero * n1, r1.slope * n2 - r2.slope * n1};
}

template <class N>
Linear<N> evaluate(const PathGeometry& g, const Pixel& at, const Motion& m) {
  switch (m.kind) {
    case MotionKind::edge:
      return edge_motion<N>(g, at, *m.first.p[0], *m.first.p[1]);
    case MotionKind::reach:
      return reach_motion<N>(g, m.first);
    case MotionKind::depth:
      return depth_motion<N>(g, at, m.first, m.second);
    case MotionKind::time:
      break;
  }
  return {N(m.time), N(1.0)};
}

/// Value of the first function at the root of the second, times the second's slope; also the first root less
/// the second, times both slopes. Degree 3 + 3, up to 6 + 6.
template <class N>
N event_order(const Linear<N>& first, const Linear<N>& second) {
  return first.at_zero * second.slope - first.slope * second.at_zero;
}

}  // namespace provis
