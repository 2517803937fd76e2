#include "src/certify/segment_rays.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/formulas.hpp"

namespace provis {
namespace {

using N = ExactNumber;

bool zero(const Vec3<N>& v) { return sign_of(dot(v, v)) == Sign::zero; }

bool on_segment(const Vec3<N>& p, const SegmentView& view) {
  const Vec3<N> from = numbers<N>(view.from), step = numbers<N>(view.to) - from, q = p - from;
  const N reached = dot(q, step);
  return zero(cross(q, step)) && sign_of(reached) != Sign::negative &&
         sign_of(dot(step, step) - reached) != Sign::negative && (!zero(step) || zero(q));
}

/// The number of the pixel whose centre is (share of the window) * count - 1/2, if there is one.
double index_of(const N& at, const N& low, const N& high, int count) {
  const double share = CGAL::to_double(at - low) / CGAL::to_double(high - low);
  return std::clamp(std::round(share * count - 0.5), 0.0, count - 1.0);
}

/// The window coordinates of a direction, times w: with Cramer's rule, so x w, y w and w.
struct WindowRay {
  N x, y, w;
};

WindowRay window_ray_of(const Vec3<N>& d, const Frame& f) {
  const Vec3<N> r = numbers<N>(f.right), u = numbers<N>(f.up), a = numbers<N>(f.forward);
  const N det = dot(cross(r, u), a);
  const N sign = sign_of(det) == Sign::negative ? N(-1.0) : N(1.0);
  return {sign * dot(cross(u, a), d), sign * dot(cross(a, r), d), sign * dot(cross(r, u), d)};
}

/// Whether at/w is low + (i + 1/2)(high - low)/count for a whole i of [0, count).
bool is_centre(const N& at, const N& w, double low, double high, int count) {
  const N l = N(low) * w, h = N(high) * w;
  const double guess = index_of(at, l, h, count);
  for (double i = std::max(0.0, guess - 1); i <= std::min(count - 1.0, guess + 1); ++i)
    if (sign_of(N(2.0 * count) * (at - l) - N(2 * i + 1) * (h - l)) == Sign::zero) return true;
  return false;
}

}  // namespace

bool belongs(const ExactRay& ray, const SegmentView& view) {
  if (!on_segment(ray.origin(), view)) return false;
  return std::any_of(view.frames.begin(), view.frames.end(), [&](const Frame& f) {
    const WindowRay r = window_ray_of(ray.direction(), f);
    // Rows count from the top, but a centre seen from above is one seen from below.
    return sign_of(r.w) == Sign::positive &&
           is_centre(r.x, r.w, f.window.x0, f.window.x1, view.pixels.width) &&
           is_centre(r.y, r.w, f.window.y0, f.window.y1, view.pixels.height);
  });
}

}  // namespace provis
