#include "predicates/line.hpp"

#include <algorithm>

namespace provis {

bool on_line_by_structure(const Line& line, const Direction& d) {
  const auto holds = [](const Line& l, std::uint32_t id) {
    return id != no_id && (l.points[0] == id || l.points[1] == id);
  };
  if (d.kind == DirectionKind::point) return holds(line, d.point_id);
  if (d.kind == DirectionKind::window)
    return (line.kind == LineKind::x_border && line.at == d.numbers.x) ||
           (line.kind == LineKind::y_border && line.at == d.numbers.y);
  if (d.kind != DirectionKind::crossing) return false;
  const Line &l = *d.lines[0], &m = *d.lines[1];
  if (&line == &l || &line == &m) return true;
  // Two distinct points make a line; the same two points make the same line.
  const auto same = [&](const Line& other) {
    return other.points[0] != other.points[1] && holds(line, other.points[0]) && holds(line, other.points[1]);
  };
  if (same(l) || same(m)) return true;
  // The depth lines of three planes taken in pairs meet in one ray.
  if (line.kind != LineKind::depth || l.kind != LineKind::depth || m.kind != LineKind::depth) return false;
  const auto has = [](const Line& x, std::uint32_t plane) {
    return x.planes[0] == plane || x.planes[1] == plane;
  };
  for (int k = 0; k < 2; ++k)
    if (has(m, l.planes[k]) && !has(m, l.planes[1 - k])) {
      const std::uint32_t rest = m.planes[0] == l.planes[k] ? m.planes[1] : m.planes[0];
      if (has(line, l.planes[1 - k]) && has(line, rest)) return true;
    }
  return false;
}

namespace {

constexpr double Vec3d::*axes[3] = {&Vec3d::x, &Vec3d::y, &Vec3d::z};

/// The plane across an axis in which all corners lie, if p lies in it too.
bool plane_holds(const Corners& t, const Vec3d& p) {
  return std::any_of(std::begin(axes), std::end(axes), [&](double Vec3d::*k) {
    return std::all_of(std::begin(t.p), std::end(t.p), [&](const Vec3d* c) { return c->*k == p.*k; });
  });
}

bool edge_holds(const ViewGeometry& g, const Vec3d& a, const Vec3d& b, const Vec3d& p) {
  if (p == a || p == b) return true;
  int equal = 0;
  for (double Vec3d::*k : axes) {
    if (a.*k != p.*k || b.*k != p.*k) continue;
    if (!g.at_infinity && g.eye.*k == p.*k) return true;
    ++equal;
  }
  return equal >= 2;
}

bool holds(const ViewGeometry& g, const Line& l, const Vec3d& p) {
  if (l.kind == LineKind::edge) return edge_holds(g, *l.first.p[0], *l.first.p[1], p);
  return l.kind == LineKind::depth && plane_holds(l.first, p) && plane_holds(l.second, p);
}

/// Both end points of one line's edge lie on the other.
bool same_line(const ViewGeometry& g, const Line& l, const Line& m) {
  const auto holds_edge = [&](const Line& line, const Line& edge) {
    return edge.kind == LineKind::edge && holds(g, line, *edge.first.p[0]) &&
           holds(g, line, *edge.first.p[1]);
  };
  return holds_edge(l, m) || holds_edge(m, l);
}

}  // namespace

bool on_line_by_coordinates(const ViewGeometry& g, const Line& line, const Direction& d) {
  if (d.kind == DirectionKind::point) return holds(g, line, *d.point);
  if (d.kind != DirectionKind::crossing) return false;
  const Line &l = *d.lines[0], &m = *d.lines[1];
  if (same_line(g, line, l) || same_line(g, line, m)) return true;
  // All three pass through one point that ends an edge.
  for (const Line* edge : {&line, &l, &m}) {
    if (edge->kind != LineKind::edge) continue;
    for (int k = 0; k < 2; ++k) {
      const Vec3d& p = *edge->first.p[k];
      if (holds(g, line, p) && holds(g, l, p) && holds(g, m, p)) return true;
    }
  }
  return false;
}

bool coplanar_by_coordinates(const Corners& first, const Corners& second) {
  return std::all_of(std::begin(second.p), std::end(second.p),
                     [&](const Vec3d* p) { return plane_holds(first, *p); });
}

}  // namespace provis
