// Event order and intervals: all certain policies against rational numbers that go another way, and the
// filter against exact numbers.

#include <CGAL/Gmpq.h>

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "src/segment/events.hpp"
#include "src/segment/exact_event.hpp"
#include "tests/segment/engine_cases.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

using Q = CGAL::Gmpq;

Sign sign_q(const Q& x) { return x > 0 ? Sign::positive : x < 0 ? Sign::negative : Sign::zero; }

/// det[d, a - v(t), b - v(t)] by Sarrus at t = 0 and t = 1: value there less value here is the slope.
Linear<Q> edge_by_values(const PathGeometry& g, const Pixel& at, const Vec3d& a, const Vec3d& b) {
  const Window& w = g.frame.window;
  const Q x = Q(w.x0) + (Q(at.column) + Q(1, 2)) * (Q(w.x1) - Q(w.x0)) / Q(g.pixels.width);
  const Q y = Q(w.y1) - (Q(at.row) + Q(1, 2)) * (Q(w.y1) - Q(w.y0)) / Q(g.pixels.height);
  const Vec3<Q> d = numbers<Q>(g.frame.forward) + x * numbers<Q>(g.frame.right) + y * numbers<Q>(g.frame.up);
  const auto value = [&](const Vec3d& v) {
    const Vec3<Q> p = numbers<Q>(a) - numbers<Q>(v), q = numbers<Q>(b) - numbers<Q>(v);
    return d.x * p.y * q.z + d.y * p.z * q.x + d.z * p.x * q.y - d.z * p.y * q.x - d.y * p.x * q.z -
           d.x * p.z * q.y;
  };
  const Q first = value(g.from), last = value(g.to);
  return {first, first - last};
}

template <Arithmetic A>
Sign order(const PathGeometry& g, const Pixel& at, const Motion& first, const Motion& second) {
  const RoundUp guard;
  SignCounts counts;
  return PathSigns<A>(g, counts).order(at, first, second);
}

struct Setting {
  EngineCase c;
  Scene scene;
  PathGeometry path;

  explicit Setting(std::uint64_t seed)
      : c(generate_engine_case(seed)),
        scene(c.scene.arrays),
        path{c.view.from, c.view.to, c.view.frames.front(), c.view.pixels} {}

  Pixel pixel(Random& random) const {
    return {random.between(0, path.pixels.width - 1), random.between(0, path.pixels.height - 1)};
  }
  Motion edge(Random& random) const {
    const std::size_t t = random.below(scene.triangles().size());
    const int k = random.between(0, 2);
    return {MotionKind::edge, 0, {{&scene.corner(t, k), &scene.corner(t, (k + 1) % 3), nullptr}}, {}};
  }
};

}  // namespace

TEST_CASE("event order is the order of rational roots, whatever the policy") {
  std::size_t zeros = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const Setting s(seed);
    INFO(describe(s.c));
    Random random(seed);
    for (int k = 0; k < 8; ++k) {
      const Pixel at = s.pixel(random);
      const Motion first = s.edge(random), second = s.edge(random);
      const Linear<Q> f = edge_by_values(s.path, at, *first.first.p[0], *first.first.p[1]),
                      g = edge_by_values(s.path, at, *second.first.p[0], *second.first.p[1]);
      const Sign expected = sign_q(f.at_zero * g.slope - f.slope * g.at_zero);
      REQUIRE(order<Arithmetic::chain>(s.path, at, first, second) == expected);
      REQUIRE(order<Arithmetic::mpfr>(s.path, at, first, second) == expected);
      REQUIRE(order<Arithmetic::exact>(s.path, at, first, second) == expected);
      REQUIRE(order<Arithmetic::chain>(s.path, at, second, first) == -expected);
      zeros += expected == Sign::zero;
    }
  }
  CHECK(zeros > 0);
}

TEST_CASE("each tier decides what only it can") {
  const PathGeometry g{{0, 0, 0}, {1, 0, 0}, Frame{}, {1, 1}};
  const Vec3d a{0.25, -1, -2}, b{0.25, 1, -2}, c{0.5, -1, -3}, d{0.5, 1, -3}, e{0.25, -2, -4}, f{0.25, 3, -4};
  const auto tier = [&](const Vec3d& p, const Vec3d& q, const Vec3d& r, const Vec3d& s, Sign expected) {
    const RoundUp guard;
    SignCounts counts;
    PathSigns<Arithmetic::chain> signs(g, counts);
    const Motion m{MotionKind::edge, 0, {{&p, &q, nullptr}}, {}},
        n{MotionKind::edge, 0, {{&r, &s, nullptr}}, {}};
    const Sign order = signs.order({0, 0}, m, n) * signs.slope({0, 0}, m) * signs.slope({0, 0}, n);
    CHECK(order == expected);
    for (const Tier t : {Tier::interval, Tier::mpfr, Tier::exact})
      if (counts.at(Predicate::event_order, t) > 0) return t;
    return Tier::filter;
  };
  CHECK(tier(a, b, c, d, Sign::negative) == Tier::interval);
  CHECK(tier(a, b, e, f, Sign::zero) == Tier::interval);
  // Times that differ by less than float64 can tell, and times that do not differ though nothing is small.
  const Vec3d near_a{0.1, -1, -2}, near_b{0.1, 1, -2}, far_c{0.1, -1.1, -3.3}, far_d{0.1, 1.7, -3.3};
  CHECK(tier(near_a, near_b, far_c, far_d, Sign::zero) == Tier::exact);
}

TEST_CASE("float64 settles nearly everything along a segment through a soup in general position") {
  const Case c = random_soup(1, 400);
  const SegmentView view{c.view.eye, c.view.eye + Vec3d{0.5, 0.25, 0.125}, c.view.frames, {40, 30}};
  const SignCounts counts = visible_from_segment(Scene(c.arrays), view).set.stats.signs;
  for (const Predicate p : {Predicate::motion, Predicate::event_order}) {
    const std::uint64_t filter = counts.at(p, Tier::filter);
    const std::uint64_t slow =
        counts.at(p, Tier::interval) + counts.at(p, Tier::mpfr) + counts.at(p, Tier::exact);
    CAPTURE(name(p), filter, slow);
    CHECK(filter > 1000);
    CHECK(1000 * slow <= filter);
  }
}

TEST_CASE("what float64 says of an interval is what exact numbers say") {
  std::size_t spans = 0, none = 0, rejected = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const Setting s(seed);
    INFO(describe(s.c));
    Random random(seed);
    SignCounts counts;
    const RoundUp guard;
    Events<Arithmetic::chain> quick(s.path, counts);
    Events<Arithmetic::exact> exact(s.path, counts);
    for (PrimitiveId id = 0; id < s.scene.triangles().size(); ++id) {
      quick.add(make_facet(s.scene, id, s.path));
      exact.add(make_facet(s.scene, id, s.path));
    }
    for (int k = 0; k < 10; ++k) {
      const Pixel at = s.pixel(random);
      const Centre centre = pixel_centre(s.path, at);
      const std::uint32_t facet = random.below(quick.facets().size());
      const auto a = quick.span(at, centre, facet, {0, 1});
      const auto b = exact.span(at, centre, facet, {0, 1});
      REQUIRE(a.has_value() == b.has_value());
      ++(a ? spans : none);
      const Window one{centre.x, centre.x, centre.y, centre.y};
      const bool missed = misses(exact.facets()[facet], one, 0, 1);
      rejected += missed;
      REQUIRE_FALSE((missed && b));
      REQUIRE_FALSE((misses(exact.facets()[facet], s.path.frame.window, 0, 1) && b));
      if (!a) continue;
      REQUIRE(exact.compare(at, a->begin, b->begin) == Sign::zero);
      REQUIRE(exact.compare(at, a->end, b->end) == Sign::zero);
      REQUIRE(a->shown.side == b->shown.side);
      REQUIRE(a->shown.on_edge == b->shown.on_edge);
      for (const Event& e : {a->begin, a->end}) {
        const Q root = exact_root(s.path, at, quick.motion(e));
        REQUIRE((root >= Q(e.t) - Q(e.error) && root <= Q(e.t) + Q(e.error)));
      }
    }
  }
  CHECK((spans > 0 && none > 0 && rejected > 0));
}

}  // namespace provis::test
