// A grid of viewpoints: away from degeneracies the z-buffer sees what the exact engine sees from the same
// ones.

#include <algorithm>
#include <catch2/catch.hpp>

#include "provis/cell.hpp"
#include "provis/error.hpp"
#include "provis/segment.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/soup.hpp"

namespace provis::test {
namespace {

using Ids = std::vector<PrimitiveId>;

const Frame ahead{{1, 0.25, 0}, {0.5, 1.5, 0.125}, {0.25, 0, -1}, {-0.5, 0.75, -1, 0.25}};

ViewCell any_place(Random& random) {
  ViewCell cell = cell_around(point(random, 1), {random.unit(), random.unit(), random.unit()});
  if (random.chance(50)) cell.window = ahead;
  if (random.chance(20)) cell.upper.y = cell.lower.y;
  return cell;
}

/// From every point whose coordinates each are one of so many, evenly spread.
Ids exact_union(const Scene& scene, const ViewCell& cell, int per_axis, const PixelGrid& pixels) {
  VisibleSet all;
  all.status.assign(scene.primitive_count(), Status::hidden);
  const std::vector<Frame> frames = cell.window ? std::vector{*cell.window} : omni({0, 0, 0}).frames;
  const auto at = [&](double lo, double hi, int k) {
    const double share = per_axis == 1 ? 0.5 : static_cast<double>(k) / (per_axis - 1);
    return std::clamp(lo * (1 - share) + hi * share, lo, hi);
  };
  for (int x = 0; x < per_axis; ++x)
    for (int y = 0; y < per_axis; ++y)
      for (int z = 0; z < per_axis; ++z) {
        const Vec3d eye{at(cell.lower.x, cell.upper.x, x), at(cell.lower.y, cell.upper.y, y),
                        at(cell.lower.z, cell.upper.z, z)};
        const SegmentSet set = visible_from_segment(scene, {eye, eye, frames, pixels}, {}, one_thread());
        for (const PrimitiveId id : set.set.with(Status::visible)) all.status[id] = Status::visible;
      }
  return all.with(Status::visible);
}

}  // namespace

TEST_CASE("a grid of viewpoints sees what the exact engine sees from them") {
  std::size_t found = 0, more = 0;
  for (const std::uint64_t seed : seeds(20)) {
    Random random(seed);
    const Scene scene(soup(random));
    const ViewCell cell = any_place(random);
    const PixelGrid pixels{17, 23};
    INFO("soup " << seed);
    const CellSet two = sampled_from_cell(scene, cell, 2, pixels);
    REQUIRE(two.set.with(Status::visible) == exact_union(scene, cell, 2, pixels));
    REQUIRE(two.set.guarantee == Guarantee::sampled);
    REQUIRE(two.bounds.viewpoints_used == 8);
    const Ids one = sampled_from_cell(scene, cell, 1, pixels).set.with(Status::visible);
    REQUIRE(one == exact_union(scene, cell, 1, pixels));
    found += one.size();
    more += two.bounds.viewpoints;
  }
  CHECK(found < more);
}

TEST_CASE("what a grid sees in a cell of general position lies within the bounds") {
  for (const std::uint64_t seed : seeds(2)) {
    Random random(seed);
    const Scene scene(soup(random));
    const ViewCell cell = any_place(random);
    INFO("soup " << seed);
    CellOptions options;
    options.pixels = {4, 4};
    options.method = CellMethod::cos;
    const CellSet upper = visible_from_cell(scene, cell, options, one_thread());
    for (const PrimitiveId id : sampled_from_cell(scene, cell, 3, {17, 17}).set.with(Status::visible))
      REQUIRE(upper.set.status[id] != Status::hidden);
  }
}

TEST_CASE("grids do not depend on the threads, and refuse what they cannot do") {
  Random random(7);
  const Scene scene(soup(random));
  const ViewCell cell = cell_around({0, 0, 0}, {1, 1, 1});
  Context many;
  many.threads = 7;
  CHECK(sampled_from_cell(scene, cell, 3, {9, 9}, one_thread()).set.status ==
        sampled_from_cell(scene, cell, 3, {9, 9}, many).set.status);
  CHECK_THROWS_AS(sampled_from_cell(scene, cell, 0, {9, 9}), Error);
  CHECK_THROWS_AS(sampled_from_cell(scene, cell, 101, {9, 9}), Error);
  CHECK_THROWS_AS(sampled_from_cell(scene, cell, 1, {0, 9}), Error);
  SceneArrays ball;
  ball.spheres = {{{0, 0, -3}, 1}};
  ball.sphere_flags = {0};
  CHECK_THROWS_AS(sampled_from_cell(Scene(ball), cell, 1, {9, 9}), Error);
}

}  // namespace provis::test
