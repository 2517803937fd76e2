#include "src/report/plan.hpp"

#include <algorithm>
#include <cmath>

namespace provis {

namespace {

struct Axes {
  Vec3d right, ahead, up;
};

// The picture's axes. Right-handed, so that nothing is mirrored: right x ahead = up.
Axes axes_for(const Vec3d& up) {
  const double x = std::abs(up.x), y = std::abs(up.y), z = std::abs(up.z);
  const Axes axes = y >= x && y >= z ? Axes{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}
                    : z >= x         ? Axes{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}
                                     : Axes{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
  if (dot(axes.up, up) >= 0) return axes;
  return {-axes.right, axes.ahead, -axes.up};
}

struct Range {
  double low = INFINITY, high = -INFINITY;

  void hold(double value, double reach) {
    low = std::min(low, value - reach);
    high = std::max(high, value + reach);
  }
  double middle() const { return low / 2 + high / 2; }
  double size() const { return high - low; }
};

Raster board(const Scene& scene, const PointView& view, const Axes& axes, int width, int height) {
  Range x, y, z;
  const auto hold = [&](const Vec3d& p, double reach) {
    x.hold(dot(axes.right, p), reach);
    y.hold(dot(axes.ahead, p), reach);
    z.hold(dot(axes.up, p), reach);
  };
  hold(view.eye, 0);
  for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
    for (int k = 0; k < 3; ++k) hold(scene.corner(t, k), 0);
  }
  for (const Sphere& sphere : scene.spheres()) hold(sphere.center, sphere.radius);

  const double unit = std::max({x.size() / width, y.size() / height, 1e-12 * (1 + std::abs(z.high))}) * 1.1;
  const double half_x = unit * width / 2, half_y = unit * height / 2;
  const double top = z.high + std::max(z.size(), unit);
  const Vec3d eye = x.middle() * axes.right + y.middle() * axes.ahead + top * axes.up;
  const Frame frame{axes.right, axes.ahead, -axes.up, {-half_x, half_x, -half_y, half_y}};
  return Raster(eye, Projection::parallel, frame, width, height);
}

}  // namespace

Plan::Plan(const Scene& scene, const PointView& view, int width, int height)
    : raster_(board(scene, view, axes_for(view.frames.front().up), width, height)),
      right_(axes_for(view.frames.front().up).right),
      ahead_(axes_for(view.frames.front().up).ahead) {}

PixelPoint Plan::point(const Vec3d& p) const {
  const Vec3d in_frame = raster_.to_frame(p);
  return raster_.to_pixels(in_frame.x, in_frame.y);
}

PixelPoint Plan::direction(const Vec3d& d) const {
  const double x = dot(right_, d), y = dot(ahead_, d);
  const double length = std::hypot(x, y);
  const bool upright = !(length > 1e-6 * std::sqrt(dot(d, d)));
  return upright ? PixelPoint{0, 0} : PixelPoint{x / length, -y / length};
}

}  // namespace provis
