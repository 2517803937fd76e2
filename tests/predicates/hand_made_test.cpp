// Cases small enough to check with a pencil: the sign, the tier that decided, and the predicate counted.

#include <catch2/catch.hpp>

#include <map>
#include <string>

#include "predicates/environment.hpp"
#include "predicates/signs.hpp"

namespace provis::test {
namespace {

constexpr double ulp = 0x1p-52;

/// Looks along -z, x to the right and y up; window coordinates are x and y at distance 1.
ViewGeometry looking_down(bool at_infinity) { return make_geometry({0, 0, 0}, Frame{}, at_infinity); }

/// A sign, and who decided it: exactly one count in one place.
struct Decided {
  Sign sign;
  Predicate predicate;
  Tier tier;

  friend bool operator==(const Decided&, const Decided&) = default;
};

std::ostream& operator<<(std::ostream& os, const Decided& d) {
  return os << "sign " << int(d.sign) << ", " << name(d.predicate) << " by " << name(d.tier);
}

template <Arithmetic A, class Ask>
Decided ask(const ViewGeometry& g, const Ask& question) {
  const RoundUp guard;
  SignCounts counts;
  Signs<A> signs(g, counts);
  Decided d{question(signs), {}, {}};
  int decisions = 0;
  for (int p = 0; p < predicate_count; ++p)
    for (int t = 0; t < tier_count; ++t)
      if (const auto n = counts.at(Predicate(p), Tier(t))) {
        decisions += int(n);
        d.predicate = Predicate(p);
        d.tier = Tier(t);
      }
  REQUIRE(decisions == 1);
  return d;
}

Decided facing(const ViewGeometry& g, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return ask<Arithmetic::chain>(g, [&](auto& signs) { return signs.facing(a, b, c); });
}

Decided front(const ViewGeometry& g, const Vec3d& p) {
  return ask<Arithmetic::chain>(g, [&](auto& signs) { return signs.front(p); });
}

template <Arithmetic A = Arithmetic::chain>
Decided side(const ViewGeometry& g, Line line, Direction direction) {
  return ask<A>(g, [&](auto& signs) {
    line.approx = signs.shadow(line);
    direction.approx = signs.shadow(direction);
    return signs.side(line, direction);
  });
}

Line edge(const Vec3d& a, const Vec3d& b) {
  Line l;
  l.first.p[0] = &a;
  l.first.p[1] = &b;
  return l;
}

Line border(LineKind kind, double at, bool negated = false) {
  Line l;
  l.kind = kind;
  l.at = at;
  l.negated = negated;
  return l;
}

Line depth(const Corners& first, const Corners& second) {
  Line l;
  l.kind = LineKind::depth;
  l.first = first;
  l.second = second;
  return l;
}

Line front_line(const Corners& triangle) {
  Line l;
  l.kind = LineKind::front;
  l.first = triangle;
  return l;
}

Direction through(const Vec3d& p) {
  Direction d;
  d.kind = DirectionKind::point;
  d.point = &p;
  return d;
}

Direction window(double x, double y) {
  Direction d;
  d.kind = DirectionKind::window;
  d.numbers = {x, y, 0};
  return d;
}

Direction given(const Vec3d& ray) {
  Direction d;
  d.numbers = ray;
  return d;
}

Direction crossing(const Line& l, const Line& m, bool negated = false) {
  Direction d;
  d.kind = DirectionKind::crossing;
  d.lines[0] = &l;
  d.lines[1] = &m;
  d.negated = negated;
  return d;
}

/// The middle vector is the sum of the others, so the eye at the origin lies in their plane. Hardly a product
/// of coordinates is exact, and b.z is so small that a hair more is lost in the rounding of any of them.
struct InEyePlane {
  Vec3d a{410. / 1024 + 0x1p-50, 700. / 1024 + 0x3p-50, 307. / 1024 + 0x5p-50};
  Vec3d c{921. / 1024 + 0x7p-50, 205. / 1024 + 0x9p-50, -307. / 1024 - 0x3p-50};
  Vec3d b{a.x + c.x, a.y + c.y, a.z + c.z};
};
constexpr double hair = 0x1p-100;

/// Clockwise for the viewer, that is at_eye > 0: a large triangle around the line of sight in plane z.
struct Wall {
  explicit Wall(double z, double tilt = 0)
      : a{-8, -8, z - 8 * tilt}, b{0, 16, z}, c{8, -8, z + 8 * tilt}, corners{{&a, &b, &c}} {}
  Wall(const Wall&) = delete;
  Vec3d a, b, c;
  Corners corners;
};

}  // namespace

TEST_CASE("facing: by the filter where it is plain") {
  const ViewGeometry eye = looking_down(false), infinity = looking_down(true);
  const Vec3d a{-1, -1, -3}, b{1, -1, -3}, c{0, 1, -3};  // counter-clockwise for the viewer
  CHECK(facing(eye, a, b, c) == Decided{Sign::negative, Predicate::facing, Tier::filter});
  CHECK(facing(eye, a, c, b) == Decided{Sign::positive, Predicate::facing, Tier::filter});
  CHECK(facing(infinity, a, b, c) == Decided{Sign::negative, Predicate::facing, Tier::filter});
  CHECK(facing(infinity, c, b, a) == Decided{Sign::positive, Predicate::facing, Tier::filter});
}

TEST_CASE("facing: edge-on triangles of small integers are zero by intervals") {
  CHECK(facing(looking_down(false), {1, 2, 3}, {4, 5, 6}, {5, 7, 9}) ==
        Decided{Sign::zero, Predicate::facing, Tier::interval});
  CHECK(facing(looking_down(true), {1, 2, 3}, {2, 4, 9}, {3, 6, 1}) ==
        Decided{Sign::zero, Predicate::facing, Tier::interval});
}

TEST_CASE("facing: full mantissas are zero, and a hair from it, by exact numbers") {
  const auto [a, c, b] = InEyePlane{};
  CHECK(facing(looking_down(false), a, b, c) == Decided{Sign::zero, Predicate::facing, Tier::exact});
  // d det[a, b, c] / d b.z = c.x a.y - c.y a.x > 0
  const Vec3d above{b.x, b.y, b.z + hair}, below{b.x, b.y, b.z - hair};
  CHECK(facing(looking_down(false), a, above, c) == Decided{Sign::positive, Predicate::facing, Tier::exact});
  CHECK(facing(looking_down(false), a, below, c) == Decided{Sign::negative, Predicate::facing, Tier::exact});
}

TEST_CASE("facing: exponents that are spread widely are left to exact arithmetic") {
  const Vec3d a{1, 1, 1}, b{0x1p-300, 2, 0x1p-300}, c{3, 7, 3};  // all in the plane x = z
  CHECK(facing(looking_down(false), a, b, c) == Decided{Sign::zero, Predicate::facing, Tier::exact});
  const Vec3d beside{b.x, b.y, 0x1p-300 * (1 + ulp)};
  CHECK(facing(looking_down(false), a, beside, c).tier == Tier::exact);
  CHECK(facing(looking_down(false), a, beside, c).sign == -facing(looking_down(false), c, beside, a).sign);
  // d det[a, b, c] / d b.z = c.x a.y - c.y a.x = 3 - 7 < 0
  CHECK(facing(looking_down(false), a, beside, c).sign == Sign::negative);
}

TEST_CASE("front: on both sides of the window's plane, and in it") {
  const ViewGeometry g = looking_down(true);
  CHECK(front(g, {1, 2, -3}) == Decided{Sign::positive, Predicate::front, Tier::filter});
  CHECK(front(g, {1, 2, 3}) == Decided{Sign::negative, Predicate::front, Tier::filter});
  CHECK(front(g, {1, 2, 0}) == Decided{Sign::zero, Predicate::front, Tier::interval});
  CHECK(front(g, {1, 2, -0x1p-1074}) == Decided{Sign::positive, Predicate::front, Tier::interval});
}

TEST_CASE("side: every kind of line against every kind of direction") {
  const bool at_infinity = GENERATE(false, true);
  const ViewGeometry g = looking_down(at_infinity);
  CAPTURE(at_infinity);

  // All four directions are the ray through window coordinates (1/4, 1/2).
  const Vec3d point{0.25, 0.5, -1};
  const Line x = border(LineKind::x_border, 0.25), y = border(LineKind::y_border, 0.5);
  // An eye at infinity looks along -z; its ray coordinates are (y, x, 1) after the mirrored shear.
  const Vec3d ray = at_infinity ? Vec3d{0.5, 0.25, 1} : Vec3d{0.25, 0.5, -1};
  // The frame is left-handed in the order forward, right, up: the crossing points backwards.
  const std::map<std::string, Direction> directions{{"point", through(point)},
                                                    {"window", window(0.25, 0.5)},
                                                    {"given", given(ray)},
                                                    {"crossing", crossing(x, y, true)}};
  const Vec3d left{-1, 0, -1}, right{1, 0, -1};
  const Wall near(-2), far(-4), behind(4);
  struct Expected {
    Line line;
    Sign sign;
    bool depth;
  };
  std::map<std::string, Expected> lines{
      {"edge rightwards", {edge(left, right), Sign::negative, false}},
      {"edge leftwards", {edge(right, left), Sign::positive, false}},
      {"left border", {border(LineKind::x_border, 0), Sign::positive, false}},
      {"right border", {border(LineKind::x_border, 1, true), Sign::positive, false}},
      {"beyond right border", {border(LineKind::x_border, 0, true), Sign::negative, false}},
      {"bottom border", {border(LineKind::y_border, -1), Sign::positive, false}},
      {"top border", {border(LineKind::y_border, 1, true), Sign::positive, false}},
      {"below bottom border", {border(LineKind::y_border, 0.75), Sign::negative, false}},
      {"image", {border(LineKind::image, 0), Sign::positive, false}},
      {"near before far", {depth(near.corners, far.corners), Sign::positive, true}},
      {"far before near", {depth(far.corners, near.corners), Sign::negative, true}}};
  if (at_infinity) {
    lines.insert({"near is in front", {front_line(near.corners), Sign::positive, true}});
    lines.insert({"behind is not", {front_line(behind.corners), Sign::negative, true}});
  }

  for (const auto& [line_name, expected] : lines)
    for (const auto& [direction_name, direction] : directions) {
      CAPTURE(line_name, direction_name);
      const bool constructed = direction.kind == DirectionKind::crossing;
      const Predicate predicate = expected.depth
                                      ? constructed ? Predicate::nearer_constructed : Predicate::nearer
                                  : constructed ? Predicate::turn_constructed
                                                : Predicate::turn;
      CHECK(side(g, expected.line, direction) == Decided{expected.sign, predicate, Tier::filter});
      CHECK(side<Arithmetic::mpfr>(g, expected.line, direction) ==
            Decided{expected.sign, predicate, Tier::mpfr});
      CHECK(side<Arithmetic::exact>(g, expected.line, direction) ==
            Decided{expected.sign, predicate, Tier::exact});
      CHECK(side<Arithmetic::doubles>(g, expected.line, direction) ==
            Decided{expected.sign, predicate, Tier::filter});
    }
}

TEST_CASE("side: a ray and its opposite lie on opposite sides") {
  const ViewGeometry g = looking_down(false);
  const Vec3d left{-1, 0, -1}, right{1, 0, -1}, above{0, 1, -1}, behind{0, 1, 1};
  Direction opposite = through(above);
  opposite.negated = true;
  CHECK(side(g, edge(left, right), through(above)).sign == Sign::negative);
  CHECK(side(g, edge(left, right), opposite).sign == Sign::positive);
  CHECK(side(g, border(LineKind::image, 0), opposite).sign == Sign::negative);
  CHECK(side(g, border(LineKind::image, 0), through(behind)).sign == Sign::negative);
}

TEST_CASE("side: on the line") {
  const bool at_infinity = GENERATE(false, true);
  const ViewGeometry g = looking_down(at_infinity);
  CAPTURE(at_infinity);
  const Vec3d point{0.25, 0.5, -1}, left{-1, 0.5, -1}, right{1, 0.5, -1};
  const Vec3d low{-0.75, 0, -1}, high{1.25, 1, -1};  // a line through the point that follows no axis
  const Line x = border(LineKind::x_border, 0.25), y = border(LineKind::y_border, 0.5);
  const Decided turn_zero{Sign::zero, Predicate::turn, Tier::interval};

  SECTION("small numbers are zero by intervals") {
    CHECK(side(g, edge(low, high), through(point)) == turn_zero);
    CHECK(side(g, edge(left, right), window(0.25, 0.5)) == turn_zero);
    CHECK(side(g, x, through(point)) == turn_zero);
    CHECK(side(g, y, through(point)) == turn_zero);
    CHECK(side(g, edge(left, right), crossing(x, y)) ==
          Decided{Sign::zero, Predicate::turn_constructed, Tier::interval});
  }
  SECTION("equal coordinates say so before intervals do") {
    const Line along = edge(left, right);
    CHECK(side(g, along, through(point)) == Decided{Sign::zero, Predicate::turn, Tier::structure});
    const Vec3d far{7, 0.5, -1}, other{0.25, 2, -1};
    const Line same = edge(point, far), oblique = edge(low, high), upright = edge(point, other);
    CHECK(side(g, along, crossing(same, oblique)) ==
          Decided{Sign::zero, Predicate::turn_constructed, Tier::structure});
    CHECK(side(g, along, crossing(upright, oblique)).sign == Sign::zero);
    const Vec3d beside{0.25, 0.5 + ulp, -1};
    CHECK(side(g, along, through(beside)).sign != Sign::zero);
    // Walls across two axes meet in a line along the third.
    const Vec3d a{-2, 0.5, -4}, b{2, 0.5, -4}, c{0, 0.5, -9}, p{1, 0.5, -4};
    const Wall wall(-4);
    CHECK(side(g, depth({{&a, &b, &c}}, wall.corners), through(p)) ==
          Decided{Sign::zero, Predicate::nearer, Tier::structure});
  }
  SECTION("where two walls cross, neither is nearer") {
    const Wall wall(-4), tilted(-4, 0.25);  // they cross at x = 0
    const Line nearer = depth(tilted.corners, wall.corners);
    CHECK(side(g, nearer, window(0, 0.5)).sign == Sign::zero);
    CHECK(side(g, nearer, window(0.25, 0.5)) == Decided{Sign::positive, Predicate::nearer, Tier::filter});
    CHECK(side(g, nearer, window(-0.25, 0.5)) == Decided{Sign::negative, Predicate::nearer, Tier::filter});
  }
  SECTION("indices say so before any arithmetic") {
    Line e = edge(left, right);
    e.points[0] = 1;
    e.points[1] = 2;
    Direction d = through(left);
    d.point_id = 1;
    CHECK(side(g, e, d) == Decided{Sign::zero, Predicate::turn, Tier::structure});
    CHECK(side(g, x, window(0.25, 7)) == Decided{Sign::zero, Predicate::turn, Tier::structure});
    CHECK(side(g, y, window(7, 0.5)) == Decided{Sign::zero, Predicate::turn, Tier::structure});
    const Direction c = crossing(x, y);
    RoundUp guard;
    SignCounts counts;
    Signs<Arithmetic::chain> signs(g, counts);
    CHECK(signs.side(*c.lines[0], c) == Sign::zero);
    CHECK(counts.at(Predicate::turn_constructed, Tier::structure) == 1);
  }
}

TEST_CASE("side: a hair from the line") {
  const ViewGeometry g = looking_down(false);
  const auto [a, c, b] = InEyePlane{};
  const Vec3d above{b.x, b.y, b.z + hair};
  CHECK(side(g, edge(a, c), through(b)) == Decided{Sign::zero, Predicate::turn, Tier::exact});
  // det[a, c, b] = -det[a, b, c]
  CHECK(side(g, edge(a, c), through(above)) == Decided{Sign::negative, Predicate::turn, Tier::exact});
  CHECK(side(g, edge(c, a), through(above)) == Decided{Sign::positive, Predicate::turn, Tier::exact});
}

TEST_CASE("side: too large or too small for the filter goes to intervals, and stays right") {
  const Vec3d left{-1, 0, -1}, right{1, 0, -1}, above{0, 1, -1};
  const ViewGeometry g = looking_down(false);
  for (const double scale : {0x1p-500, 0x1p-250, 0x1p450}) {
    CAPTURE(scale);
    const Vec3d a = scale * left, b = scale * right, p = scale * above;
    const Decided d = side(g, edge(a, b), through(p));
    CHECK(d.sign == Sign::negative);
    CHECK(d.tier != Tier::filter);
    CHECK(d.tier != Tier::structure);
  }
}

TEST_CASE("vanishes: only for two triangles of one plane") {
  const bool at_infinity = GENERATE(false, true);
  const ViewGeometry g = looking_down(at_infinity);
  const Wall wall(-4), other(-5);
  const Vec3d a{-2, -2, -4}, b{0, 2, -4}, c{2, -2, -4};
  const auto vanishes = [&](const Corners& first, const Corners& second) {
    return ask<Arithmetic::chain>(g, [&](auto& signs) {
      Line l = depth(first, second);
      l.approx = signs.shadow(l);
      return signs.vanishes(l) ? Sign::zero : Sign::positive;
    });
  };
  CHECK(vanishes(wall.corners, other.corners) == Decided{Sign::positive, Predicate::coplanar, Tier::filter});
  CHECK(vanishes(wall.corners, {{&a, &b, &c}}) == Decided{Sign::zero, Predicate::coplanar, Tier::structure});
  const Wall tilted(-4, 0.25);
  const Vec3d d{0, 0, -4}, e{4, 0, -3}, f{0, 4, -4};
  CHECK(vanishes(tilted.corners, {{&d, &e, &f}}) == Decided{Sign::zero, Predicate::coplanar, Tier::interval});
  const Vec3d bent{2, -2, -4 - 4 * ulp};
  CHECK(vanishes(wall.corners, {{&a, &b, &bent}}).sign == Sign::positive);
}

TEST_CASE("a frame of dependent vectors is no view") {
  Frame f;
  f.up = {2, 0, 0};
  CHECK_THROWS(make_geometry({0, 0, 0}, f, false));
  f.up = {1, 0x1p-1074, 0};
  CHECK(make_geometry({0, 0, 0}, f, false).handedness == Sign::negative);
}

}  // namespace provis::test
