#include "src/segment/depth_buffer.hpp"

#include <algorithm>

namespace provis {
namespace {

std::size_t index(int column, int row, int width) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
}

double determinant(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return dot(a, cross(b, c)); }

/// The whole numbers in [low, high], cut to [0, count); all of them where a bound is not a number.
struct Range {
  int first, last;
};
Range whole_numbers(double low, double high, int count) {
  return {low > 0 ? static_cast<int>(std::ceil(std::min<double>(low, count))) : 0,
          high < count - 1 ? static_cast<int>(std::floor(std::max(high, -1.0))) : count - 1};
}

}  // namespace

PixelView::PixelView(const Vec3d& eye, const Frame& frame, const PixelGrid& pixels)
    : eye_(eye), pixels_(pixels) {
  const double d = determinant(frame.right, frame.up, frame.forward);
  const Vec3d x = 1 / d * cross(frame.up, frame.forward), y = 1 / d * cross(frame.forward, frame.right),
              z = 1 / d * cross(frame.right, frame.up);
  const Window& w = frame.window;
  const double per_x = pixels.width / (w.x1 - w.x0), per_y = pixels.height / (w.y1 - w.y0);
  rows_ = {per_x * x - (per_x * w.x0 + 0.5) * z, (per_y * w.y1 - 0.5) * z - per_y * y, z};
  // Half a pixel is left over at each side for roundings.
  inward_ = {rows_[0] + z, static_cast<double>(pixels.width) * z - rows_[0], rows_[1] + z,
             static_cast<double>(pixels.height) * z - rows_[1], z};
  orientation_ = d > 0 ? -1 : 1;  // rows run downwards
}

bool PixelView::misses(const ClusterBox& box) const {
  return std::any_of(inward_.begin(), inward_.end(), [&](const Vec3d& n) {
    const Vec3d farthest{n.x > 0 ? box.upper.x : box.lower.x, n.y > 0 ? box.upper.y : box.lower.y,
                         n.z > 0 ? box.upper.z : box.lower.z};
    return dot(n, farthest - eye_) < 0;
  });
}

std::optional<Silhouette> PixelView::silhouette(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                                                bool single_sided) const {
  const Vec3d p = to_pixels(a), q = to_pixels(b), r = to_pixels(c);
  const double least = std::min({p.z, q.z, r.z});
  if (!(std::max({p.z, q.z, r.z}) > 0)) return std::nullopt;
  Silhouette s;
  s.box = {0, 0, pixels_.width, pixels_.height};
  if (least > 0) {
    const auto [low_x, high_x] = std::minmax({p.x / p.z, q.x / q.z, r.x / r.z});
    const auto [low_y, high_y] = std::minmax({p.y / p.z, q.y / q.z, r.y / r.z});
    const Range columns = whole_numbers(low_x, high_x, pixels_.width),
                rows = whole_numbers(low_y, high_y, pixels_.height);
    if (columns.first > columns.last || rows.first > rows.last) return std::nullopt;
    s.box = {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
    s.nearest = 1 / least;
  }
  s.edges = {cross(q, r), cross(r, p), cross(p, q)};
  const double d = dot(p, s.edges[0]);
  const bool back = d * orientation_ > 0;
  if (d == 0 || (single_sided && back)) return std::nullopt;
  for (Vec3d& e : s.edges)
    if (d < 0) e = -1.0 * e;
  s.nearness = 1 / std::fabs(d) * (s.edges[0] + s.edges[1] + s.edges[2]);
  return s;
}

DepthBuffer::DepthBuffer(const PixelGrid& pixels)
    : pixels_(pixels),
      tile_columns_((pixels.width + tile - 1) / tile),
      nearness_(index(0, pixels.height, pixels.width)),
      farthest_(index(0, (pixels.height + tile - 1) / tile, tile_columns_)) {}

void DepthBuffer::clear() { std::fill(nearness_.begin(), nearness_.end(), 0.0); }

/// use(first, count, nearness of the first, its step) for the pixels of each row that are hit, until it says
/// so.
template <class Use>
bool DepthBuffer::scan(const Silhouette& s, const Use& use) const {
  std::array<double, 3> root{}, per_row{};
  for (std::size_t k = 0; k < 3; ++k) {
    root[k] = -s.edges[k].z / s.edges[k].x;
    per_row[k] = -s.edges[k].y / s.edges[k].x;
  }
  for (int row = s.box.row; row < s.box.row + s.box.height; ++row) {
    double first = s.box.column, last = s.box.column + s.box.width - 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3d& e = s.edges[k];
      if (e.x == 0) {
        if (e.y * row + e.z < 0) last = -1;
      } else if (const double x = root[k] + per_row[k] * row; e.x > 0) {
        first = std::max(first, x);
      } else {
        last = std::min(last, x);
      }
    }
    if (!(first <= last)) continue;
    const int left = static_cast<int>(first) + (static_cast<int>(first) < first),
              right = static_cast<int>(last);
    if (left > right) continue;
    const double nearness = s.nearness.x * left + (s.nearness.y * row + s.nearness.z);
    if (use(index(left, row, pixels_.width), right - left + 1, nearness, s.nearness.x)) return true;
  }
  return false;
}

void DepthBuffer::add(const Silhouette& s) {
  scan(s, [&](std::size_t first, int count, double nearness, double step) {
    for (int k = 0; k < count; ++k)
      nearness_[first + static_cast<std::size_t>(k)] =
          std::max(nearness_[first + static_cast<std::size_t>(k)], nearness + step * k);
    return false;
  });
}

void DepthBuffer::finish() {
  std::fill(farthest_.begin(), farthest_.end(), HUGE_VAL);
  for (int row = 0; row < pixels_.height; ++row)
    for (int column = 0; column < pixels_.width; ++column) {
      double& least = farthest_[index(column / tile, row / tile, tile_columns_)];
      least = std::min(least, nearness_[index(column, row, pixels_.width)]);
    }
}

bool DepthBuffer::behind_tiles(const Silhouette& s) const {
  for (int row = s.box.row / tile; row <= (s.box.row + s.box.height - 1) / tile; ++row)
    for (int column = s.box.column / tile; column <= (s.box.column + s.box.width - 1) / tile; ++column)
      if (!(s.nearest * clearly < farthest_[index(column, row, tile_columns_)])) return false;
  return true;
}

bool DepthBuffer::shows(const Silhouette& s) const {
  if (behind_tiles(s)) return false;
  return scan(s, [&](std::size_t first, int count, double nearness, double step) {
    for (int k = 0; k < count; ++k)
      if ((nearness + step * k) * clearly >= nearness_[first + static_cast<std::size_t>(k)]) return true;
    return false;
  });
}

}  // namespace provis
