// Cutting convex cells: both parts, lines through corners, and areas that add up.

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "src/point/area.hpp"
#include "src/point/tile.hpp"

namespace provis {
namespace {

/// A window seen along -z by a frame of either handedness, and a cell cutter for it.
struct Bench {
  explicit Bench(bool left_handed = false)
      : geometry(make_geometry({0, 0, 0}, frame(left_handed), false)),
        signs(geometry, counts),
        tile(make_tile(signs, {-1, 1, -1, 1})),
        points(signs, positions),
        cutter(signs, points) {}

  static Frame frame(bool left_handed) {
    Frame f;
    if (left_handed) f.right = -f.right;
    return f;
  }

  /// A vertical border at x, positive to its right.
  Line border(double x) {
    Line l;
    l.kind = LineKind::x_border;
    l.at = x;
    l.approx = signs.shadow(l);
    return l;
  }

  RoundUp guard;
  ViewGeometry geometry;
  SignCounts counts;
  Signs<Arithmetic::chain> signs;
  Tile tile;
  std::vector<const Vec3d*> positions;
  ImagePoints<Arithmetic::chain> points;
  CellCutter<Arithmetic::chain> cutter;
};

Rational size(const Bench& b, const Cell& c) { return area(window_polygon(b.geometry, c)); }

}  // namespace

TEST_CASE("a tile is a cell of the window's area whose corners lie inside its lines") {
  for (const bool left_handed : {false, true}) {
    Bench b(left_handed);
    const Cell c = make_cell(b.tile, b.geometry.handedness);
    CHECK(size(b, c) == 4);
    for (const Side& side : c.lines) {
      CellSigns s;
      const auto [positive, negative] = b.cutter.classify(c, side, s);
      CHECK(positive);
      CHECK_FALSE(negative);
    }
  }
}

TEST_CASE("both parts of a cut add up to the cell") {
  for (const bool left_handed : {false, true}) {
    Bench b(left_handed);
    const Line l = b.border(0.25);
    const Cell c = make_cell(b.tile, b.geometry.handedness);
    CellSigns s;
    REQUIRE(b.cutter.classify(c, {&l, false}, s) == std::pair(true, true));
    const Cell right = b.cutter.part(c, {&l, false}, s, Sign::positive);
    const Cell left = b.cutter.part(c, {&l, false}, s, Sign::negative);
    CHECK(size(b, right) == Rational(3) / 2);
    CHECK(size(b, left) == Rational(5) / 2);
    CHECK(right.lines.size() == 4);
    CHECK(left.lines.size() == 4);
  }
}

TEST_CASE("a line through two opposite corners leaves two triangles without new vertices") {
  Bench b;
  const Vec3d p{-1, -1, -1}, q{1, 1, -1};
  Line diagonal;
  diagonal.kind = LineKind::edge;
  diagonal.first.p[0] = &p;
  diagonal.first.p[1] = &q;
  diagonal.approx = b.signs.shadow(diagonal);
  const Cell c = make_cell(b.tile, b.geometry.handedness);
  CellSigns s;
  REQUIRE(b.cutter.classify(c, {&diagonal, false}, s) == std::pair(true, true));
  for (const Sign wanted : {Sign::positive, Sign::negative}) {
    const Cell half = b.cutter.part(c, {&diagonal, false}, s, wanted);
    CHECK(half.lines.size() == 3);
    CHECK(size(b, half) == 2);
    for (const Direction& v : half.vertices) CHECK(v.kind == DirectionKind::window);
  }
}

TEST_CASE("a line that only touches the cell does not cut it") {
  Bench b;
  const Line l = b.border(1);
  CellSigns s;
  const auto [positive, negative] =
      b.cutter.classify(make_cell(b.tile, b.geometry.handedness), {&l, false}, s);
  CHECK_FALSE(positive);
  CHECK(negative);
}

}  // namespace provis
