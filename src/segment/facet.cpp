#include "src/segment/facet.hpp"

#include <tuple>

namespace provis {
namespace {

bool before(const Vec3d& a, const Vec3d& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); }

/// normal . (forward + x right + y up)
WindowFunction function_of(const Vec3<Ball>& normal, const Frame& f, const WindowExtent& extent) {
  const Ball a = dot(normal, numbers<Ball>(f.right)), b = dot(normal, numbers<Ball>(f.up)),
             c = dot(normal, numbers<Ball>(f.forward));
  WindowFunction w =
      window_function({a.value, b.value, c.value}, std::max({a.radius, b.radius, c.radius}), extent);
  w.error = (w.error + 4 * unit_roundoff * extent.of(w.a, w.b, 0)) * (1 + 0x1p-20);
  return w;
}

}  // namespace

MovingFacet make_facet(const Scene& scene, PrimitiveId id, const PathGeometry& path) {
  MovingFacet f;
  f.id = id;
  const std::uint8_t flags = scene.triangle_flags()[id];
  f.occludes = !(flags & see_through);
  f.single_sided = flags & single_sided;
  const WindowExtent extent(path.frame.window);
  const Vec3<Ball> from = numbers<Ball>(path.from), step = numbers<Ball>(path.to) - from;
  for (int k = 0; k < 3; ++k) f.corners.p[k] = &scene.corner(id, k);
  for (int k = 0; k < 3; ++k) {
    const Vec3d *a = f.corners.p[k], *b = f.corners.p[(k + 1) % 3];
    f.turned[k] = before(*b, *a);
    if (f.turned[k]) std::swap(a, b);
    f.edges[k].p[0] = a;
    f.edges[k].p[1] = b;
    const Vec3<Ball> e = numbers<Ball>(*b) - numbers<Ball>(*a);
    f.edge[k] = {function_of(cross(numbers<Ball>(*a) - from, e), path.frame, extent),
                 function_of(cross(step, e), path.frame, extent)};
  }
  const Vec3<Ball> a = numbers<Ball>(*f.corners.p[0]);
  const Vec3<Ball> n = cross(numbers<Ball>(*f.corners.p[1]) - a, numbers<Ball>(*f.corners.p[2]) - a);
  f.along = function_of(n, path.frame, extent);
  f.reach_at_zero = dot(n, a - from);
  f.reach_slope = dot(n, step);
  return f;
}

bool misses(const MovingFacet& f, const Window& w, double begin, double end) {
  const bool back = f.along.lowest(w) > 0;
  if (!back && !(f.along.highest(w) < 0)) return false;
  if (back && f.single_sided) return true;
  for (int k = 0; k < 3; ++k) {
    const auto outside = [&](double t) {
      const WindowFunction& s = f.edge[k].slope;
      const WindowFunction e = difference(f.edge[k].at_zero, {t * s.a, t * s.b, t * s.c, s.error});
      return back != f.turned[k] ? e.highest(w) < 0 : e.lowest(w) > 0;
    };
    // Linear in t, and at each t in the window: negative at the corners of both means negative everywhere.
    if (outside(begin) && outside(end)) return true;
  }
  return false;
}

Centre pixel_centre(const PathGeometry& path, const Pixel& at) {
  const Window& w = path.frame.window;
  const auto between = [](double from, double to, int index, int count) {
    const double i = 2.0 * index + 1, n = 2.0 * count;
    return ((n - i) * from + i * to) / n;
  };
  return {between(w.x0, w.x1, at.column, path.pixels.width), between(w.y1, w.y0, at.row, path.pixels.height)};
}

}  // namespace provis
