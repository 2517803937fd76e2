// Images: drawing the visible set alone gives the full scene's depth at each pixel's centre, at every time
// that is no event of the pixel.

#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/segment/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

/// The scene with all but these triangles gone; the others keep their ids.
SceneArrays only(const SceneArrays& scene, const std::vector<PrimitiveId>& ids) {
  SceneArrays rest = scene;
  for (PrimitiveId id = 0; id < rest.triangles.size(); ++id)
    if (!std::binary_search(ids.begin(), ids.end(), id)) rest.triangles[id] = {0, 0, 0};
  return rest;
}

/// A time strictly between two neighbouring events.
Rational between_events(const std::vector<Rational>& events, Random& random) {
  const std::size_t i = random.below(events.size() - 1);
  return events[i] + Rational(random.between(1, 6), 7) * (events[i + 1] - events[i]);
}

/// Calls body(full, reduced, pixel, time) for a few times of each pixel.
template <class Body>
void for_looks(int share, const Body& body) {
  for (const std::uint64_t seed : seeds(share)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    const SegmentView view = c.view();
    const SegmentOracle full(c.start.arrays, view);
    const SegmentOracle reduced(only(c.start.arrays, engine_answer(c).visible), view);
    Random random(seed);
    for_pixels(view, [&](const Pixel& p) {
      const std::vector<Rational> events = full.events(p);
      for (int i = 0; i < 3; ++i) {
        const Rational t = between_events(events, random);
        INFO("pixel " << p.frame << ' ' << p.column << ' ' << p.row << " at " << t);
        body(full.look(p, t), reduced.look(p, t));
      }
    });
  }
}

}  // namespace

TEST_CASE("the visible set alone gives the full scene's depth at every pixel between its events") {
  std::size_t covered = 0, all = 0;
  for_looks(20, [&](const Look& full, const Look& reduced) {
    REQUIRE(full.nearest == reduced.nearest);
    ++all;
    covered += full.nearest > 0;
  });
  CHECK((8 * covered > all && covered < all));
}

TEST_CASE("the visible set alone shows at every pixel what the full scene shows") {
  for_looks(10, [](const Look& full, const Look& reduced) { REQUIRE(full.visible == reduced.visible); });
}

}  // namespace provis::test
