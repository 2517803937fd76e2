// What indices alone can tell, and what they must not.

#include <catch2/catch.hpp>

#include "predicates/line.hpp"

namespace provis::test {
namespace {

Line line(LineKind kind, std::uint32_t p, std::uint32_t q, std::uint32_t i = no_id, std::uint32_t j = no_id) {
  Line l;
  l.kind = kind;
  l.points[0] = p;
  l.points[1] = q;
  l.planes[0] = i;
  l.planes[1] = j;
  return l;
}

Line border(LineKind kind, double at) {
  Line l;
  l.kind = kind;
  l.at = at;
  return l;
}

Direction point(std::uint32_t id) {
  Direction d;
  d.kind = DirectionKind::point;
  d.point_id = id;
  return d;
}

Direction window(double x, double y) {
  Direction d;
  d.kind = DirectionKind::window;
  d.numbers = {x, y, 0};
  return d;
}

Direction crossing(const Line& l, const Line& m) {
  Direction d;
  d.kind = DirectionKind::crossing;
  d.lines[0] = &l;
  d.lines[1] = &m;
  return d;
}

}  // namespace

TEST_CASE("structure: an end point lies on its edge") {
  const Line e = line(LineKind::edge, 3, 5);
  CHECK(on_line_by_structure(e, point(3)));
  CHECK(on_line_by_structure(e, point(5)));
  CHECK_FALSE(on_line_by_structure(e, point(4)));
  CHECK_FALSE(on_line_by_structure(e, point(no_id)));
  CHECK_FALSE(on_line_by_structure(line(LineKind::edge, no_id, no_id), point(no_id)));
  CHECK(on_line_by_structure(line(LineKind::depth, 7, no_id, 0, 1), point(7)));
}

TEST_CASE("structure: a window ray lies on the borders it was made from") {
  CHECK(on_line_by_structure(border(LineKind::x_border, 0.5), window(0.5, 3)));
  CHECK(on_line_by_structure(border(LineKind::y_border, 3), window(0.5, 3)));
  CHECK_FALSE(on_line_by_structure(border(LineKind::x_border, 3), window(0.5, 3)));
  CHECK_FALSE(on_line_by_structure(border(LineKind::y_border, 0.5), window(0.5, 3)));
  CHECK_FALSE(on_line_by_structure(border(LineKind::image, 0), window(0, 0)));
}

TEST_CASE("structure: a crossing lies on the lines that cross, and on copies of them") {
  const Line l = line(LineKind::edge, 1, 2), m = line(LineKind::edge, 3, 4),
             other = line(LineKind::edge, 1, 4);
  const Line again = line(LineKind::edge, 2, 1);
  const Direction c = crossing(l, m);
  CHECK(on_line_by_structure(l, c));
  CHECK(on_line_by_structure(m, c));
  CHECK(on_line_by_structure(again, c));
  CHECK_FALSE(on_line_by_structure(other, c));
  // The crossing of two planes through an edge of both is that edge's line.
  CHECK(on_line_by_structure(line(LineKind::depth, 1, 2, 0, 1), c));
  // One point is not enough to make a line, not even twice.
  CHECK_FALSE(on_line_by_structure(line(LineKind::edge, 1, 1), crossing(line(LineKind::edge, 1, 1), m)));
}

TEST_CASE("structure: the depth lines of three planes meet") {
  const auto depth = [](std::uint32_t i, std::uint32_t j) {
    return line(LineKind::depth, no_id, no_id, i, j);
  };
  const Line ij = depth(0, 1), jk = depth(1, 2), ik = depth(0, 2), kj = depth(2, 1), jl = depth(1, 3),
             kl = depth(2, 3);
  CHECK(on_line_by_structure(ik, crossing(ij, jk)));
  CHECK(on_line_by_structure(ij, crossing(jk, ik)));
  CHECK(on_line_by_structure(jk, crossing(ik, ij)));
  CHECK(on_line_by_structure(ik, crossing(kj, ij)));
  CHECK_FALSE(on_line_by_structure(ik, crossing(ij, jl)));
  CHECK_FALSE(on_line_by_structure(kl, crossing(ij, jk)));
  CHECK_FALSE(on_line_by_structure(ij, crossing(kl, jk)));
  const Line no_planes = depth(no_id, no_id), also_none = depth(no_id, no_id),
             none_either = depth(no_id, no_id);
  CHECK_FALSE(on_line_by_structure(no_planes, crossing(also_none, none_either)));
  const Line edge = line(LineKind::edge, 8, 9);
  CHECK_FALSE(on_line_by_structure(ik, crossing(ij, edge)));
}

TEST_CASE("structure: a ray that is given has none") {
  Direction d;
  d.numbers = {0, 0, 1};
  CHECK_FALSE(on_line_by_structure(border(LineKind::x_border, 0), d));
}

}  // namespace provis::test
