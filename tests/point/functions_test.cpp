// What float64 claims about rays and rectangles, held against exact signs.

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "src/point/leaf_lines.hpp"
#include "src/point/polygon.hpp"
#include "src/point/tile.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

using Exact = Signs<Arithmetic::exact>;

/// One frame of a case: all its facets, and the exact signs of their lines.
struct FrameOf {
  FrameOf(const Case& c, const Scene& scene, std::size_t frame)
      : geometry(make_geometry(c.view.eye, c.view.frames[frame], c.view.projection == Projection::parallel)),
        signs(geometry, counts),
        window(c.view.frames[frame].window),
        facets(of(signs, scene, window)),
        part(signs, facets),
        lines(signs, facets, part) {}

  template <Arithmetic A>
  static Facets of(Signs<A>& signs, const Scene& scene, const Window& window) {
    std::vector<PrimitiveId> ids(scene.triangles().size());
    for (std::size_t t = 0; t < ids.size(); ++t) ids[t] = static_cast<PrimitiveId>(t);
    return make_facets(signs, scene, window, ids);
  }

  Sign sign(const Side& side, double x, double y) {
    const Sign s = signs.side(*side.line, window_direction(signs, {x, y, 0}));
    return side.negated ? -s : s;
  }

  ViewGeometry geometry;
  SignCounts counts;
  Exact signs;
  Window window;
  Facets facets;
  PartLines<Arithmetic::exact> part;
  LeafLines<Arithmetic::exact> lines;
};

/// A ray of the window, often on its border or through a facet's corner as float64 has it.
PolygonCorner ray(const FrameOf& f, Random& random) {
  const Window& w = f.window;
  const auto within = [&](double lo, double hi) {
    return random.chance(20) ? random.pick({lo, hi}) : std::clamp(lo + random.unit() * (hi - lo), lo, hi);
  };
  return {within(w.x0, w.x1), within(w.y0, w.y1)};
}

/// A claim is certain or none; how often it was certain.
struct Claims {
  void hold(double value, double error, Sign exact) {
    ++asked;
    if (std::fabs(value) > error) {
      ++certain;
      REQUIRE(exact == (value > 0 ? Sign::positive : Sign::negative));
    }
  }
  std::size_t asked = 0, certain = 0;
};

/// Calls body with a frame of every generated case.
template <class Body>
void for_frames(const Body& body) {
  for (const std::uint64_t seed : seeds(20)) {
    const Case c = generate(seed);
    INFO(describe(c));
    Random random(seed);
    const RoundUp guard;
    const Scene scene(c.arrays);
    FrameOf frame(c, scene, random.below(c.view.frames.size()));
    body(frame, random);
  }
}

}  // namespace

TEST_CASE("functions of window coordinates have the signs of their lines, wherever they are certain") {
  Claims claims;
  for_frames([&](FrameOf& frame, Random& random) {
    const auto& facets = frame.facets.facets;
    for (std::uint32_t f = 0; f < facets.size(); ++f) {
      const PolygonCorner at = ray(frame, random);
      for (std::size_t k = 0; k < 3; ++k) {
        const WindowFunction& inside = facets[f].inside[k];
        claims.hold(inside.at(at.x, at.y), inside.error,
                    frame.sign({&frame.part.of(f).edges[k]}, at.x, at.y));
      }
      const std::uint32_t other = random.below(facets.size());
      if (other == f) continue;
      const WindowFunction before = difference(facets[f].depth, facets[other].depth);
      const Side nearer = frame.lines.depth(f, other);
      claims.hold(before.at(at.x, at.y), before.error,
                  nearer.line == nullptr ? Sign::zero : frame.sign(nearer, at.x, at.y));
    }
  });
  CHECK(2 * claims.certain > claims.asked);
}

TEST_CASE("a facet's box holds every ray on which it is hit, and bounds of a rectangle hold on its rays") {
  for_frames([&](FrameOf& frame, Random& random) {
    for (std::uint32_t f = 0; f < frame.facets.facets.size(); ++f) {
      const Facet& facet = frame.facets.facets[f];
      const PolygonCorner p = ray(frame, random), q = ray(frame, random);
      const Window between{std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y), std::max(p.y, q.y)};
      bool hit = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const Sign s = frame.sign({&frame.part.of(f).edges[k]}, p.x, p.y);
        hit &= s != Sign::negative;
        if (facet.inside[k].lowest(between) > 0) REQUIRE(s == Sign::positive);
        if (facet.inside[k].highest(between) < 0) REQUIRE(s == Sign::negative);
      }
      if (hit) REQUIRE(overlap(facet.box, {p.x, p.x, p.y, p.y}));
    }
  });
}

}  // namespace provis::test
