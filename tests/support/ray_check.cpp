#include "tests/support/ray_check.hpp"

#include <gmpxx.h>

#include <algorithm>

#include "tests/support/box_tree.hpp"

namespace provis::test {

namespace {

using Rational = mpq_class;
using Rational3 = Vec3<Rational>;

Rational exact(const Dyadic& d) {
  Rational value(mpz_class(d.mantissa, 10));
  if (d.exponent >= 0) {
    mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(d.exponent));
  } else {
    mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), static_cast<mp_bitcnt_t>(-d.exponent));
  }
  return value;
}

Rational3 exact(const Vec3<Dyadic>& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }
Rational3 exact(const Vec3d& v) { return {v.x, v.y, v.z}; }

Rational determinant(const Rational3& a, const Rational3& b, const Rational3& c) {
  return dot(cross(a, b), c);
}

bool is_zero(const Rational3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

/// d = x right + y up + z forward; returns (x, y, z).
Rational3 along_frame(const Frame& f, const Rational3& d) {
  const Rational3 r = exact(f.right), u = exact(f.up), w = exact(f.forward);
  const Rational det = determinant(r, u, w);
  return {Rational(determinant(d, u, w) / det), Rational(determinant(r, d, w) / det),
          Rational(determinant(r, u, d) / det)};
}

bool in_window(const Window& w, const Rational& x, const Rational& y) {
  return x >= w.x0 && x <= w.x1 && y >= w.y0 && y <= w.y1;
}

struct Ray {
  Rational3 origin, direction;
};

/// True if the view holds the ray in one of its closed windows.
bool belongs(const PointView& view, const Ray& ray) {
  const Rational3 offset = ray.origin - exact(view.eye);
  if (view.projection == Projection::parallel) {
    const Frame& f = view.frames.front();
    const Rational3 at = along_frame(f, offset), d = along_frame(f, ray.direction);
    return at.z == 0 && in_window(f.window, at.x, at.y) && d.x == 0 && d.y == 0 && d.z > 0;
  }
  if (!is_zero(offset)) return false;
  return std::any_of(view.frames.begin(), view.frames.end(), [&](const Frame& f) {
    const Rational3 d = along_frame(f, ray.direction);
    return d.z > 0 && in_window(f.window, Rational(d.x / d.z), Rational(d.y / d.z));
  });
}

/// A triangle and its normal.
struct Plane {
  Rational3 corner[3];
  Rational3 normal;

  Plane(const SceneArrays& scene, std::size_t t) {
    for (std::size_t k = 0; k < 3; ++k) corner[k] = exact(scene.vertices[scene.triangles[t][k]]);
    normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  }

  Rational height(const Rational3& p) const { return dot(normal, p - corner[0]); }

  bool holds(const Plane& other) const {
    return height(other.corner[0]) == 0 && height(other.corner[1]) == 0 && height(other.corner[2]) == 0;
  }

  /// -1 outside, 0 on the border, 1 in the relative interior; for a point of the plane.
  int locate(const Rational3& p) const {
    int least = 1;
    for (int k = 0; k < 3; ++k) {
      const Rational3 &a = corner[k], &b = corner[(k + 1) % 3];
      least = std::min(least, sgn(dot(cross(b - a, p - a), normal)));
    }
    return least;
  }
};

}  // namespace

struct RayChecker::Impl {
  const SceneArrays& scene;
  const PointView view;
  BoxTree tree;

  Impl(const SceneArrays& s, const PointView& v) : scene(s), view(v), tree(s) {}

  /// The triangle has hits from the ray's origin, and from a side that is not culled.
  bool shows(std::size_t t, const Plane& plane, const Ray& ray) const {
    const bool parallel = view.projection == Projection::parallel;
    const int towards = parallel ? -sgn(dot(plane.normal, ray.direction)) : sgn(plane.height(ray.origin));
    const bool culls = (scene.triangle_flags[t] & single_sided) != 0;
    return towards != 0 && (towards > 0 || !culls);
  }

  /// The plane from which a parallel view's rays start is hit by none of them at a distance > 0 (R6). Any
  /// other triangle that an origin lies on hides what is next to it, and so spoils a witness.
  bool is_window_plane(const Plane& plane) const {
    const Frame& f = view.frames.front();
    return view.projection == Projection::parallel && dot(plane.normal, exact(f.right)) == 0 &&
           dot(plane.normal, exact(f.up)) == 0 && plane.height(exact(view.eye)) == 0;
  }

  /// True if the triangle shows and meets the closed segment origin + [0, end] direction.
  bool blocks(std::size_t t, const Plane& plane, const Ray& ray, const Rational& end) const {
    if (!shows(t, plane, ray)) return false;
    const Rational fall = dot(plane.normal, ray.direction);
    if (fall == 0) return false;  // parallel to the plane, which does not hold the eye
    const Rational distance = -plane.height(ray.origin) / fall;
    if (distance < 0 || distance > end || is_window_plane(plane)) return false;
    return plane.locate(ray.origin + distance * ray.direction) >= 0;
  }

  std::string refuse(const Witness& witness) const;
};

std::string RayChecker::Impl::refuse(const Witness& witness) const {
  const Ray ray{exact(witness.origin), exact(witness.direction)};
  if (is_zero(ray.direction)) return "the direction is zero";
  if (!belongs(view, ray)) return "the ray does not belong to the view";
  if (witness.primitive >= scene.triangles.size()) return "no such triangle";

  const Plane target(scene, witness.primitive);
  const Rational fall = dot(target.normal, ray.direction);
  if (fall == 0 || !shows(witness.primitive, target, ray))
    return "the triangle is edge-on, degenerate or culled";
  const Rational distance = -target.height(ray.origin) / fall;
  if (distance <= 0) return "the triangle lies behind the origin";
  const Rational3 hit = ray.origin + distance * ray.direction;
  if (target.locate(hit) <= 0) return "the ray misses the triangle's relative interior";

  std::string reason;
  tree.visit_segment(ray.origin, hit, [&](PrimitiveId t) {
    if (t == witness.primitive || (scene.triangle_flags[t] & see_through) != 0) return true;
    const Plane plane(scene, t);
    if (target.holds(plane) || !blocks(t, plane, ray, distance)) return true;
    reason = "triangle " + std::to_string(t) + " meets the segment";
    return false;
  });
  return reason;
}

RayChecker::RayChecker(const SceneArrays& scene, const PointView& view)
    : impl_(std::make_unique<Impl>(scene, view)) {}
RayChecker::~RayChecker() = default;

std::string RayChecker::refuse(const Witness& witness) const { return impl_->refuse(witness); }

bool ray_check(const Scene& scene, const PointView& view, const Witness& witness) {
  return RayChecker(scene, view).refuse(witness).empty();
}

}  // namespace provis::test
