#include "predicates/line.hpp"

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

}  // namespace provis
