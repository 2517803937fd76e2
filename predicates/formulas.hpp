#pragma once
// Every polynomial, once, over any number type: float64, Ball, Interval, MpfiNumber, ExactNumber.

#include "predicates/view_geometry.hpp"
#include "provis/vec3.hpp"

namespace provis {

template <class N>
Vec3<N> numbers(const Vec3d& p) {
  return {N(p.x), N(p.y), N(p.z)};
}

template <class V>
auto& component(V& v, int axis) {
  return axis == 0 ? v.x : axis == 1 ? v.y : v.z;
}

/// The plane of a triangle: normal, offset from the window's origin (eye at infinity only), and the
/// product with the viewpoint. The depth of a ray q is (normal·q + offset)/at_eye once at_eye > 0; it
/// grows towards the viewer: inverse distance for a finite eye, minus the distance for one at infinity.
template <class N>
struct Plane {
  Vec3<N> normal;
  N offset;
  N at_eye;
};

/// Drops the coordinate along which an eye at infinity looks; w is 1 for points and 0 for vectors.
template <class N>
Vec3<N> sheared(const ViewGeometry& g, const Vec3<N>& q, double w) {
  const Vec3<N> d = numbers<N>(g.shear_direction);
  const auto [i, j, k] = g.axes;
  const N& dk = component(d, k);
  const N& qk = component(q, k);
  return {component(q, i) * dk - qk * component(d, i), component(q, j) * dk - qk * component(d, j),
          N(w) * dk};
}

/// The ray through a point. Degree 1 (eye at infinity: 2).
template <class N>
Vec3<N> project_point(const ViewGeometry& g, const Vec3d& p) {
  const Vec3<N> q = numbers<N>(p) - numbers<N>(g.eye);
  return g.at_infinity ? sheared(g, q, 1) : q;
}

/// The direction of a vector in the image. Degree 1 (eye at infinity: 2).
template <class N>
Vec3<N> project_vector(const ViewGeometry& g, const Vec3d& v) {
  return g.at_infinity ? sheared(g, numbers<N>(v), 0) : numbers<N>(v);
}

/// The ray through the middle of the frame.
template <class N>
Vec3<N> frame_center(const ViewGeometry& g) {
  return g.at_infinity ? sheared(g, Vec3<N>{N(0), N(0), N(0)}, 1) : numbers<N>(g.forward);
}

/// The ray through window coordinates (x, y). Degree 1 (eye at infinity: 2) in lengths, 1 in x and y.
template <class N>
Vec3<N> window_ray(const ViewGeometry& g, double x, double y) {
  return frame_center<N>(g) + N(x) * project_vector<N>(g, g.right) + N(y) * project_vector<N>(g, g.up);
}

/// Positive where the window coordinate x exceeds the given one (times the handedness). Degree 2 (eye at
/// infinity: 4) in lengths, 1 in x.
template <class N>
Vec3<N> x_border(const ViewGeometry& g, double x) {
  return cross(project_vector<N>(g, g.up), frame_center<N>(g) + N(x) * project_vector<N>(g, g.right));
}

/// Positive where the window coordinate y exceeds the given one (times the handedness). Degree 2 (eye at
/// infinity: 4) in lengths, 1 in y.
template <class N>
Vec3<N> y_border(const ViewGeometry& g, double y) {
  return cross(frame_center<N>(g) + N(y) * project_vector<N>(g, g.up), project_vector<N>(g, g.right));
}

/// Positive on the window's side of the image, for turning a line through the viewpoint into a ray
/// (times the handedness). Degree 2 (eye at infinity: 4).
template <class N>
Vec3<N> image_side(const ViewGeometry& g) {
  return cross(project_vector<N>(g, g.right), project_vector<N>(g, g.up));
}

/// Positive where det[a-e, b-e, p-e] is: as the viewer sees it, to the right of the projected edge from a to
/// b. Degree 2 (eye at infinity: 4).
template <class N>
Vec3<N> edge_line(const ViewGeometry& g, const Vec3d& a, const Vec3d& b) {
  return cross(project_point<N>(g, a), project_point<N>(g, b));
}

/// Degrees: normal 2, offset 3, at_eye 3. at_eye has the sign of det[a-e, b-e, c-e]: positive where the
/// corners run clockwise for the viewer, that is where the triangle is seen from behind.
template <class N>
Plane<N> triangle_plane(const ViewGeometry& g, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3<N> o = numbers<N>(a);
  const Vec3<N> n = cross(numbers<N>(b) - o, numbers<N>(c) - o);
  const N from_eye = dot(n, o - numbers<N>(g.eye));
  if (g.at_infinity) return {n, -from_eye, dot(n, numbers<N>(g.forward))};
  return {n, N(0), from_eye};
}

/// The plane of the window, for the cut at distance 0 of an eye at infinity; at_eye > 0.
template <class N>
Plane<N> window_plane(const ViewGeometry& g) {
  const Vec3<N> r = numbers<N>(g.right), u = numbers<N>(g.up);
  const Vec3<N> n = g.handedness == Sign::positive ? cross(r, u) : cross(u, r);
  return {n, N(0), dot(n, numbers<N>(g.forward))};
}

/// Positive on the window's far side, the one that is looked at. Degree 3.
template <class N>
N beyond_window(const ViewGeometry& g, const Vec3d& p) {
  return dot(window_plane<N>(g).normal, numbers<N>(p) - numbers<N>(g.eye));
}

/// Positive where the first plane is nearer, both with at_eye > 0. Degree 5, and 6 in the last coefficient
/// for an eye at infinity, where that coordinate of a ray has one degree less. It vanishes on the crossing of
/// both planes, and everywhere iff they are one plane.
template <class N>
Vec3<N> depth_line(const ViewGeometry& g, const Plane<N>& first, const Plane<N>& second) {
  const Vec3<N> f = second.at_eye * first.normal - first.at_eye * second.normal;
  if (!g.at_infinity) return f;
  const auto [i, j, k] = g.axes;
  return {component(f, i), component(f, j), second.at_eye * first.offset - first.at_eye * second.offset};
}

}  // namespace provis
