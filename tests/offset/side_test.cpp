// What lies outside one side of a line, and where a side falls apart. One corner of the face is enough to
// make a difference, so it is asked of each.

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "src/offset/side.hpp"
#include "tests/offset/lower_face.hpp"

namespace provis::test {
namespace {

using namespace provis::offset;

Mesh::Edge edge(const Vec3d& a, const Vec3d& b, std::uint32_t first) {
  return {{&a, &b}, {first, first + 1}, 0, 0};
}

}  // namespace

TEST_CASE("an edge is left out only if it is so from all four corners of the face") {
  const RoundUp guard;
  const Face face = lower_face({{-0.5, -0.5, 0}, {0.5, 0.5, 1}, {}});
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double at : {1 - 0x1p-40, 1.0, 1 + 0x1p-40}) {
        // All in the plane |x| + |y| = at, which passes the corner (x/2, y/2, 0) on either side, or meets it.
        const Vec3d a{x * at, 0, -1}, b{0, y * at, -1}, c{x * at, 0, -2}, d{0, y * at, -2};
        const Mesh::Edge line = edge(a, b, 0), other = edge(c, d, 2);
        INFO(x << ' ' << y << ' ' << at);
        CHECK(Side(face, line, true).leaves_out(line));
        CHECK(Side(face, line, false).leaves_out(line));
        const int sides =
            Side(face, line, true).leaves_out(other) + Side(face, line, false).leaves_out(other);
        CHECK(sides == (at < 1 ? 0 : 1));
      }
}

TEST_CASE("an edge with one end on the side is not left out") {
  const RoundUp guard;
  const Face face = lower_face({{-0.5, -0.5, 0}, {0.5, 0.5, 1}, {}});
  const Vec3d a{0, -1, -1}, b{0, 1, -1}, left{-9, 0, -1}, right{9, 0, -1}, far{9, 1, -1};
  const Mesh::Edge line = edge(a, b, 0), across = edge(left, right, 2), beside = edge(right, far, 4);
  const auto sides_without = [&](const Mesh::Edge& e) {
    return Side(face, line, true).leaves_out(e) + Side(face, line, false).leaves_out(e);
  };
  CHECK(sides_without(across) == 0);
  CHECK(sides_without(beside) == 1);
}

TEST_CASE("nothing is claimed of a side that falls apart") {
  // Seen along the line: from the face's right end the triangle's right corner is passed on one side if it
  // stands high enough, while the line lies behind it; from the left end, the lower corners are passed on
  // that side beyond the line. Between the two lies the other side, and parts them.
  const RoundUp guard;
  const Face face = lower_face({{-0.176, -0.5, 1}, {5.67, 0.5, 2}, {}});
  const Vec3d a{0, -1, 0}, b{0, 1, 0};
  const Mesh::Edge line = edge(a, b, 0);
  for (const double high : {0.194, 0.1}) {
    const Polygon part = whole({0.1, -1, -0.63}, {0.1, 1, -0.63}, {1, 0, high});
    for (const bool positive : {false, true}) {
      INFO(high << ' ' << positive);
      const auto segment = Side(face, line, positive).some_segment(part);
      CHECK(segment.has_value() == (high < 0.15));
      if (!segment) continue;
      const Interval h = turn(a, b, segment->to, segment->from);
      CHECK((positive ? h.inf() > 0 : h.sup() < 0));
    }
  }
}

}  // namespace provis::test
