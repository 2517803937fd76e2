// The engine against the oracle, on scenes and segments made to be degenerate.

#include <catch2/catch.hpp>

#include <algorithm>
#include <iterator>

#include "tests/segment/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

/// Compares all that both say on a share of the generated cases.
void require_agreement(int share, const SegmentOptions& options) {
  for (const std::uint64_t seed : seeds(share)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    const SegmentAnswer expected = oracle_along(c.start.arrays, c.view());
    SegmentSet set;
    REQUIRE(difference(engine_answer(c, options, {}, &set), answer_of(expected)) == "");
    REQUIRE(difference(set.seen, expected.seen) == "");
    REQUIRE(set.set.status.size() == c.start.arrays.triangles.size());
    REQUIRE(set.set.with(Status::undecided).empty());
    REQUIRE(set.set.guarantee == Guarantee::exact);
    REQUIRE(set.set.answers == "R10");
  }
}

SegmentOptions with(Arithmetic arithmetic, SegmentEngine engine) {
  SegmentOptions options;
  options.arithmetic = arithmetic;
  options.engine = engine;
  return options;
}

/// 300 triangles in general position, a wall before them with a hole through which some are seen on the way,
/// and pixels enough for what is hidden to be skipped in blocks.
SegmentCase soup_behind_a_wall(std::uint64_t seed) {
  SegmentCase c;
  c.start = random_soup(seed, 300);
  c.start.view.eye = {-1, 0.25, 6};
  c.to = {1.5, -0.25, 5.5};
  c.pixels = {12, 8};
  const auto quad = [&](double x0, double x1, double y0, double y1) {
    SceneArrays& scene = c.start.arrays;
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    for (const Vec3d& v : {Vec3d{x0, y0, 4}, {x1, y0, 4}, {x1, y1, 4}, {x0, y1, 4}})
      scene.vertices.push_back(v);
    for (const Triangle& t : {Triangle{first, first + 1, first + 2}, Triangle{first, first + 2, first + 3}}) {
      scene.triangles.push_back(t);
      scene.triangle_flags.push_back(0);
    }
  };
  quad(-9, -0.5, -9, 9);
  quad(0.25, 9, -9, 9);
  quad(-0.5, 0.25, -9, -0.25);
  quad(-0.5, 0.25, 0.5, 9);
  return c;
}

}  // namespace

TEST_CASE("the engine gives the oracle's sets and sights on every generated segment") {
  require_agreement(100, with(Arithmetic::chain, SegmentEngine::fast));
}

TEST_CASE("the plain engine gives the oracle's sets and sights") {
  require_agreement(40, with(Arithmetic::chain, SegmentEngine::plain));
}

TEST_CASE("exact arithmetic gives the oracle's sets and sights along segments") {
  require_agreement(10, with(Arithmetic::exact, SegmentEngine::fast));
  require_agreement(10, with(Arithmetic::exact, SegmentEngine::plain));
}

TEST_CASE("MPFR gives the oracle's sets and sights along segments") {
  require_agreement(10, with(Arithmetic::mpfr, SegmentEngine::fast));
  require_agreement(10, with(Arithmetic::mpfr, SegmentEngine::plain));
}

TEST_CASE("a segment that is cut for want of memory gives the same sets and sights") {
  for (const std::uint64_t bytes : {std::uint64_t{1}, std::uint64_t{2000}, std::uint64_t{20000}}) {
    SegmentOptions options;
    options.memory_bytes = bytes;
    require_agreement(5, options);
  }
}

TEST_CASE("plain doubles end on every generated segment and promise nothing") {
  for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain}) {
    for (const std::uint64_t seed : seeds(20)) {
      const SegmentCase c = generate_segment(seed);
      INFO(describe(c));
      SegmentSet set;
      engine_answer(c, with(Arithmetic::doubles, engine), {}, &set);
      REQUIRE(set.set.guarantee == Guarantee::sampled);
      REQUIRE(set.set.status.size() == c.start.arrays.triangles.size());
    }
  }
}

TEST_CASE("soups of some hundred triangles behind a wall with a hole agree too, by both engines") {
  for (const std::uint64_t seed : seeds(1)) {
    const SegmentCase c = soup_behind_a_wall(seed);
    INFO("soup " << seed);
    const Answer expected = answer_of(oracle_along(c.start.arrays, c.view()));
    for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain})
      REQUIRE(difference(engine_answer(c, with(Arithmetic::chain, engine)), expected) == "");
  }
}

TEST_CASE("a segment without length answers the point query at pixel centres") {
  for (const std::uint64_t seed : seeds(10)) {
    SegmentCase c = generate_segment(seed);
    c.to = c.start.view.eye;
    INFO(describe(c));
    const SegmentView view = c.view();
    const Answer found = engine_answer(c);
    for (const ExactSights& p : found.pixels) REQUIRE(p.sights.size() == 1);

    // A checker of single rays, which knows no segments, says what is in R10° at this point.
    const RayChecker checker(c.start.arrays, c.start.view);
    std::vector<PrimitiveId> proper;
    std::set_difference(found.visible.begin(), found.visible.end(), found.boundary.begin(),
                        found.boundary.end(), std::back_inserter(proper));
    std::vector<PrimitiveId> accepted;
    for (PrimitiveId id = 0; id < c.start.arrays.triangles.size(); ++id) {
      bool any = false;
      for (const ExactSights& p : found.pixels) {
        Witness ray = ray_along(view, {p.frame, p.column, p.row}, view.from);
        ray.primitive = id;
        any = any || checker.refuse(ray).empty();
      }
      if (any) accepted.push_back(id);
    }
    REQUIRE(text(proper) == text(accepted));
  }
}

}  // namespace provis::test
