// The oracle against a checker of single rays that shares nothing with it, and against itself by other ways.

#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/support/environment.hpp"
#include "tests/support/pixel_ray.hpp"
#include "tests/support/random.hpp"
#include "tests/support/ray_check.hpp"
#include "tests/support/segment_cases.hpp"
#include "tests/support/segment_oracle.hpp"

namespace provis::test {
namespace {

bool contains(const std::vector<PrimitiveId>& ids, PrimitiveId id) {
  return std::binary_search(ids.begin(), ids.end(), id);
}

}  // namespace

TEST_CASE("generated segments show something, hide something, and have boundaries and events") {
  std::size_t visible = 0, triangles = 0, boundary = 0, sights = 0, pixels = 0;
  for (const std::uint64_t seed : seeds(20)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    REQUIRE(c.start.arrays.triangles.size() == c.start.arrays.triangle_flags.size());
    const SegmentAnswer answer = oracle_along(c.start.arrays, c.view());
    triangles += c.start.arrays.triangles.size();
    visible += answer.visible.size();
    boundary += answer.boundary.size();
    pixels += answer.pixels.size();
    for (const ExactSights& p : answer.pixels) sights += p.sights.size();
  }
  WARN(triangles << " triangles, " << visible << " visible, " << boundary << " of them at the boundary; "
                 << sights << " sights in " << pixels << " pixels");
  if (seeds(20).size() < 100) return;
  CHECK((10 * visible > triangles && 10 * visible < 9 * triangles));
  CHECK(50 * boundary > visible);
  CHECK(2 * sights > 3 * pixels);
}

TEST_CASE("generated segments have what each planted mistake gets wrong") {
  for (const SegmentPlant plant :
       {SegmentPlant::drop_an_occluder, SegmentPlant::flip_a_tie, SegmentPlant::use_an_epsilon,
        SegmentPlant::forget_camera_event, SegmentPlant::forget_crossings}) {
    int different = 0;
    for (std::uint64_t seed = 0; seed < 150 && different < 5; ++seed) {
      const SegmentCase c = generate_segment(seed);
      const auto pixels = [&](SegmentPlant p) { return oracle_along(c.start.arrays, c.view(), p).pixels; };
      different += pixels(plant) != pixels(SegmentPlant::none);
    }
    INFO("plant " << static_cast<int>(plant));
    CHECK(different == 5);
  }
}

TEST_CASE("sights fill the segment, and each shows what its rays see, whichever triangles are tried") {
  for (const std::uint64_t seed : seeds(5)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    const SegmentOracle oracle(c.start.arrays, c.view());
    Random random(seed);
    for_pixels(c.view(), [&](const Pixel& p) {
      const ExactSights all = oracle.sights(p);
      const std::vector<Rational> events = oracle.events(p);
      Rational at = 0;
      for (const ExactSight& s : all.sights) {
        REQUIRE(s.from == at);
        REQUIRE(s.from < s.to);
        at = s.to;
        const Rational t = s.from + Rational(random.between(1, 62), 63) * (s.to - s.from);
        if (std::binary_search(events.begin(), events.end(), t)) continue;
        REQUIRE(oracle.look(p, t).visible == s.visible);
      }
      REQUIRE(at == 1);
    });
  }
}

TEST_CASE("what the oracle calls proper is what a checker of single rays accepts") {
  std::size_t accepted = 0, refused = 0;
  for (const std::uint64_t seed : seeds(10)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    const SegmentView view = c.view();
    const SegmentOracle oracle(c.start.arrays, view);
    const Rational t(1 + 2 * static_cast<int>(seed % 32), 64);
    const std::optional<Vec3d> eye = eye_at(view, t);
    if (!eye) continue;
    PointView from_there{*eye, Projection::pinhole, view.frames};
    const RayChecker checker(c.start.arrays, from_there);
    for_pixels(view, [&](const Pixel& p) {
      const Look look = oracle.look(p, t);
      Witness ray = ray_along(view, p, *eye);
      for (PrimitiveId id = 0; id < c.start.arrays.triangles.size(); ++id) {
        ray.primitive = id;
        const bool holds = checker.refuse(ray).empty();
        INFO("pixel " << p.frame << ' ' << p.column << ' ' << p.row << ", triangle " << id << ", t " << t);
        REQUIRE(holds == contains(look.proper, id));
        if (contains(look.visible, id)) ++(holds ? accepted : refused);
      }
    });
  }
  WARN(accepted << " rays accepted, " << refused << " refused at the boundary");
}

}  // namespace provis::test
