// From-point sampling: away from degeneracies the z-buffer sees what the exact engine sees from the same
// viewpoints.

#include <algorithm>
#include <catch2/catch.hpp>

#include "provis/error.hpp"
#include "provis/segment.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"
#include "tests/support/soup.hpp"

namespace provis::test {
namespace {

SegmentView view_of(Random& random) {
  SegmentView view{point(random, 1), point(random, 1), omni({0, 0, 0}).frames, {19, 23}};
  if (random.chance(50))
    view.frames = {{{1, 0.25, 0}, {0.5, 1.5, 0.125}, {0.25, 0, -1}, {-0.5, 0.75, -1, 0.25}},
                   {{-1, 0, 0}, {0, 1, 0}, {0, 0, -2}, {-1, 1, -1, 1}}};
  return view;
}

std::vector<PrimitiveId> exact_union(const Scene& scene, const SegmentView& view, int viewpoints) {
  VisibleSet all;
  all.status.assign(scene.primitive_count(), Status::hidden);
  for (int k = 0; k < viewpoints; ++k) {
    const Vec3d eye = view.from + (k + 0.5) / viewpoints * (view.to - view.from);
    const SegmentSet set = visible_from_segment(scene, {eye, eye, view.frames, view.pixels});
    for (const PrimitiveId id : set.set.with(Status::visible)) all.status[id] = Status::visible;
  }
  return all.with(Status::visible);
}

using Ids = std::vector<PrimitiveId>;

Ids sampled(const SceneArrays& arrays, int viewpoints = 1) {
  const SegmentView view{{-1, 0, 0}, {1, 0, 0}, {Frame{}}, {3, 3}};
  return sampled_along_segment(Scene(arrays), view, viewpoints).set.with(Status::visible);
}

const Vec3d left{-90, -90, -4}, right{90, -90, -4}, top{0, 90, -4};

}  // namespace

TEST_CASE(
    "sampled viewpoints see what the exact engine sees from them, and no more than it sees on the way") {
  std::size_t found = 0, all = 0;
  for (const std::uint64_t seed : seeds(10)) {
    Random random(seed);
    const Scene scene(soup(random));
    const SegmentView view = view_of(random);
    INFO("soup " << seed);
    const int viewpoints = random.pick({1, 2, 7});
    const SegmentSet set = sampled_along_segment(scene, view, viewpoints);
    const Ids ids = set.set.with(Status::visible);
    REQUIRE(ids == exact_union(scene, view, viewpoints));
    REQUIRE(set.boundary == ids);
    REQUIRE(set.seen.empty());
    REQUIRE(set.set.guarantee == Guarantee::sampled);
    const Ids whole = visible_from_segment(scene, view).set.with(Status::visible);
    REQUIRE(std::includes(whole.begin(), whole.end(), ids.begin(), ids.end()));
    found += ids.size();
    all += whole.size();
  }
  CHECK(found < all);
}

TEST_CASE("samples: coincident triangles are all found, and see-through ones before the wall") {
  const SceneArrays wall = with({}, left, right, top);
  CHECK(sampled(with(wall, left, right, top)) == Ids{0, 1});
  CHECK(sampled(with(wall, right, top, left)) == Ids{0, 1});
  const Vec3d back{0, 0, -2}, before{0, 0, 2};
  CHECK(sampled(with(wall, left + before, right + before, top + before, see_through)) == Ids{0, 1});
  CHECK(sampled(with(wall, left + back, right + back, top + back, see_through)) == Ids{0});
  CHECK(sampled(with(wall, left + back, right + back, top + back)) == Ids{0});
  CHECK(sampled(with(wall, left + before, right + before, top + before, single_sided)) == Ids{1});
  CHECK(sampled(with(wall, right + before, left + before, top + before, single_sided)) == Ids{0});
}

TEST_CASE("samples: what is seen between viewpoints only is missed") {
  // A slit in front of a narrow post: seen while the camera passes 0.
  SceneArrays arrays = with({}, {-90, -90, -2}, {-0.01, -90, -2}, {-0.01, 90, -2});
  arrays = with(arrays, {0.01, -90, -2}, {90, -90, -2}, {0.01, 90, -2});
  arrays = with(arrays, {-0.01, -9, -4}, {0.01, -9, -4}, {0, 9, -4});
  CHECK(sampled(arrays, 2) == Ids{0, 1});
  CHECK(sampled(arrays, 3) == Ids{0, 1, 2});
}

TEST_CASE("samples: nothing to see, no viewpoint, spheres") {
  CHECK(sampled({}) == Ids{});
  CHECK_THROWS_AS(sampled({}, 0), Error);
  SceneArrays ball;
  ball.spheres = {{{0, 0, -3}, 1}};
  ball.sphere_flags = {0};
  CHECK_THROWS_AS(sampled(ball), Error);
}

TEST_CASE("samples do not depend on the threads") {
  Random random(7);
  const Scene scene(soup(random));
  const SegmentView view = view_of(random);
  Context one, many;
  one.threads = 1;
  many.threads = 7;
  CHECK(sampled_along_segment(scene, view, 9, one).set.status ==
        sampled_along_segment(scene, view, 9, many).set.status);
}

}  // namespace provis::test
