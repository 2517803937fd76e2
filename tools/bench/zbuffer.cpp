#include "tools/bench/zbuffer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace provis::bench {

namespace {

/// An edge from p to q: a x + b y + c, positive on its left.
struct Edge {
  double a, b, c;

  template <class P>
  Edge(const P& p, const P& q) : a(p.y - q.y), b(q.x - p.x), c(p.x * q.y - q.x * p.y) {}
};

/// Where an edge cuts rows: x = at + slope y. It bounds them from one side; a level edge, from none.
struct Crossing {
  double at, slope;
  bool left, right;

  explicit Crossing(const Edge& e) : at(-e.c / e.a), slope(-e.b / e.a), left(e.a > 0), right(e.a < 0) {}
};

using Span = ZBuffer::Span;

/// Whole numbers in [low, high], within [0, count). Comparisons first: a conversion must not overflow.
Span whole(double low, double high, int count) {
  if (!(low <= count - 1 && high >= 0)) return {0, -1};
  Span span{0, count - 1};
  if (low > 0) {
    span.first = static_cast<int>(low);
    if (span.first < low) ++span.first;
  }
  if (high < count - 1) span.last = static_cast<int>(high);
  return span;
}

/// The part of a row that lies inside of all edges.
Span cut(Span row, const std::array<Crossing, 3>& crossings, double y) {
  double low = row.first, high = row.last;
  for (const Crossing& c : crossings) {
    const double x = c.at + c.slope * y;
    low = c.left && x > low ? x : low;
    high = c.right && x < high ? x : high;
  }
  if (high < low) return {0, -1};
  const int first = static_cast<int>(low);
  return {first + (first < low ? 1 : 0), static_cast<int>(high)};
}

}  // namespace

ZBuffer::ZBuffer(int width, int height)
    : width_(width),
      height_(height),
      inverse_depth_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)),
      id_(inverse_depth_.size(), nothing) {}

void ZBuffer::set_view(const PointView& view) {
  const Frame& f = view.frames.front();
  const Window& w = f.window;
  eye_ = view.eye;
  const double determinant = dot(f.forward, cross(f.right, f.up));
  const auto row = [&](const Vec3d& a, const Vec3d& b) { return 1 / determinant * cross(a, b); };
  const Vec3d x = row(f.up, f.forward), y = row(f.forward, f.right);
  row_depth_ = row(f.right, f.up);
  const double scale_x = width_ / (w.x1 - w.x0), scale_y = height_ / (w.y0 - w.y1);
  row_x_ = scale_x * x + (-scale_x * w.x0 - 0.5) * row_depth_;
  row_y_ = scale_y * y + (-scale_y * w.y1 - 0.5) * row_depth_;
}

ZBuffer::Homogeneous ZBuffer::transform(const Vec3d& p) const {
  const Vec3d d = p - eye_;
  return {dot(row_x_, d), dot(row_y_, d), dot(row_depth_, d)};
}

void ZBuffer::draw(const Scene& scene, const PointView& view) {
  set_view(view);
  const auto projected = std::make_unique_for_overwrite<Projected[]>(scene.vertices().size());
  std::ranges::transform(scene.vertices(), projected.get(),
                         [&](const Vec3d& p) { return divide(transform(p)); });
  for (std::uint32_t t = 0; t < scene.triangles().size(); ++t) {
    const Triangle& v = scene.triangles()[t];
    const Projected &a = projected[v[0]], &b = projected[v[1]], &c = projected[v[2]];
    const int ahead = (a.inverse > 0) + (b.inverse > 0) + (c.inverse > 0);
    if (ahead == 3) {
      add(a, b, c, t);
    } else if (ahead > 0) {
      add_clipped(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2), t);
    }
  }
}

void ZBuffer::add(const Projected& a, const Projected& b, const Projected& c, std::uint32_t id) {
  const Span rows = whole(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), height_);
  if (rows.empty()) return;
  const Span columns = whole(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), width_);
  if (columns.empty()) return;
  const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  if (area == 0) return;

  const Projected &p = area > 0 ? b : c, &q = area > 0 ? c : b;
  const std::array<Edge, 3> edges = {Edge(a, p), Edge(p, q), Edge(q, a)};
  // 1 / depth over the image, from the corners' barycentric coordinates.
  const double scale = 1 / std::abs(area);
  const double dp = scale * (p.inverse - a.inverse), dq = scale * (q.inverse - a.inverse);
  const double step_x = dp * edges[2].a + dq * edges[0].a, step_y = dp * edges[2].b + dq * edges[0].b;
  const double origin = a.inverse + dp * edges[2].c + dq * edges[0].c;

  const std::array<Crossing, 3> crossings = {Crossing(edges[0]), Crossing(edges[1]), Crossing(edges[2])};
  for (int y = rows.first; y <= rows.last; ++y) {
    const Span span = cut(columns, crossings, y);
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    const double at_row = origin + step_y * y;
    for (int x = span.first; x <= span.last; ++x) {
      const double here = at_row + step_x * x;
      const std::size_t pixel = row + static_cast<std::size_t>(x);
      if (here <= inverse_depth_[pixel]) continue;
      inverse_depth_[pixel] = here;
      id_[pixel] = id;
    }
  }
}

// What lies nearer than a tiny part of the triangle's own depth is cut off.
void ZBuffer::add_clipped(const Vec3d& a, const Vec3d& b, const Vec3d& c, std::uint32_t id) {
  const std::array<Homogeneous, 3> corners = {transform(a), transform(b), transform(c)};
  const double nearest = 1e-9 * std::max({corners[0].z, corners[1].z, corners[2].z});
  std::array<Projected, 4> ring{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Homogeneous &p = corners[k], &q = corners[(k + 1) % 3];
    if (p.z >= nearest) ring[count++] = divide(p);
    if ((p.z >= nearest) != (q.z >= nearest)) {
      const double part = (nearest - p.z) / (q.z - p.z);
      Homogeneous cut = p + part * (q - p);
      cut.z = nearest;
      ring[count++] = divide(cut);
    }
  }
  for (std::size_t k = 2; k < count; ++k) add(ring[0], ring[k - 1], ring[k], id);
}

std::vector<std::uint8_t> ZBuffer::seen(std::size_t triangles) const {
  std::vector<std::uint8_t> flags(triangles, 0);
  for (const std::uint32_t id : id_)
    if (id != nothing) flags[id] = 1;
  return flags;
}

}  // namespace provis::bench
