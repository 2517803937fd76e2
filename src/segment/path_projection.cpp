#include "src/segment/path_projection.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/approx.hpp"

namespace provis {
namespace {

/// Of a pixel: what is added on either side for rounding.
constexpr double pixel_slack = 0x1p-5;

bool much_wider(double low, double high, int pixels) {
  return (high - low) / pixels * pixel_slack > 0x1p-44 * std::max(std::fabs(low), std::fabs(high));
}

}  // namespace

PathProjection::PathProjection(const PathGeometry& path, double reach) : path_(path) {
  const Frame& f = path.frame;
  const double o = dot(cross(f.right, f.up), f.forward) > 0 ? 1 : -1;
  row_x_ = o * cross(f.up, f.forward);
  row_y_ = o * cross(f.forward, f.right);
  row_z_ = o * cross(f.right, f.up);
  determinant_ = dot(row_z_, f.forward);
  // ERRORS.md, 10.
  const double vector = std::max({largest(f.right), largest(f.up), largest(f.forward)});
  const double window = 1 + std::max(WindowExtent(f.window).x, WindowExtent(f.window).y);
  const double rows = 2 * vector * vector * window;
  skew_ = 0x1p-44 * vector * rows * window / determinant_;
  const bool usable = determinant_ > 0x1p-300 && determinant_ < 0x1p300 && skew_ < 0x1p-10 &&
                      rows < 0x1p200 && reach < 0x1p200;
  margin_ = usable ? 0x1p-42 * rows * reach + 0x1p-900 : HUGE_VAL;
  fine_x_ = much_wider(f.window.x0, f.window.x1, path.pixels.width);
  fine_y_ = much_wider(f.window.y0, f.window.y1, path.pixels.height);
}

Vec3d PathProjection::viewpoint(double t) const { return path_.from + t * (path_.to - path_.from); }

/// Between which quotients x/z all points of the convex hull before the camera lie.
PathProjection::Side PathProjection::reach_of(const double* x, const double* z) const {
  const double m = margin_;
  const auto at_most = [&](double p, double q) { return (p + m) / (p + m > 0 ? q - m : q + m); };
  const auto at_least = [&](double p, double q) { return -at_most(-p, q); };
  // A side x* bounds the hull if every point lies on that side: those behind the camera the other way round.
  double high = -HUGE_VAL, behind_high = HUGE_VAL, low = HUGE_VAL, behind_low = -HUGE_VAL;
  for (int k = 0; k < 6; ++k) {
    if (z[k] > m) {
      high = std::max(high, at_most(x[k], z[k]));
      low = std::min(low, at_least(x[k], z[k]));
    } else if (z[k] < -m) {
      // x/z = (-x)/(-z)
      behind_high = std::min(behind_high, at_least(-x[k], -z[k]));
      behind_low = std::max(behind_low, at_most(-x[k], -z[k]));
    } else {
      return {-HUGE_VAL, HUGE_VAL};
    }
  }
  return {low > behind_low ? low : -HUGE_VAL, high < behind_high ? high : HUGE_VAL};
}

PixelRect PathProjection::pixels(const Vec3d& a, const Vec3d& b, const Vec3d& c, const TimeRange& range,
                                 const PixelRect& area) const {
  if (!(margin_ < HUGE_VAL)) return area;
  const PixelRect none{area.column, area.row, 0, 0};
  const Vec3d v[2] = {viewpoint(range.begin), viewpoint(range.end)};
  const Vec3d* p[3] = {&a, &b, &c};
  double x[6], y[6], z[6];
  bool before = false;
  for (int k = 0; k < 6; ++k) {
    const Vec3d q = *p[k % 3] - v[k / 3];
    x[k] = dot(row_x_, q);
    y[k] = dot(row_y_, q);
    z[k] = dot(row_z_, q);
    before |= !(z[k] < -margin_);
  }
  if (!before) return none;
  const Window& w = path_.frame.window;
  // Cuts [first, first + count) to where centres lie between low and high, measured from `origin` in pixels.
  const auto cut = [](double low, double high, int& first, int& count) {
    const double lo = std::ceil(low - 0.5 - pixel_slack - std::fabs(low) * 0x1p-40),
                 hi = std::floor(high - 0.5 + pixel_slack + std::fabs(high) * 0x1p-40);
    const int last = first + count - 1;
    const int new_last = hi < last ? static_cast<int>(std::max(hi, first - 1.0)) : last;
    if (lo > first) first = static_cast<int>(std::min(lo, last + 1.0));
    count = std::max(0, new_last - first + 1);
  };
  PixelRect r = area;
  if (fine_x_) {
    const Side s = reach_of(x, z);
    const double per = path_.pixels.width / (w.x1 - w.x0);
    cut((s.low - w.x0) * per, (s.high - w.x0) * per, r.column, r.width);
  }
  if (fine_y_) {
    const Side s = reach_of(y, z);
    const double per = path_.pixels.height / (w.y1 - w.y0);
    cut((w.y1 - s.high) * per, (w.y1 - s.low) * per, r.row, r.height);
  }
  return r.width > 0 && r.height > 0 ? r : none;
}

}  // namespace provis
