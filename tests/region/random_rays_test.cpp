// Random rays: what they prove is checked by exact numbers that share no code with them, and is never called
// hidden.

#include <catch2/catch.hpp>

#include "provis/cell.hpp"
#include "provis/witness.hpp"
#include "src/region/covered_cell.hpp"
#include "src/region/random_rays.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

/// Whatever some rays at each triangle prove, and nothing else.
CellSet proven(const Scene& scene, const ViewCell& cell, int rays) {
  const RandomRays random(scene, cell);
  CellSet set;
  set.set.status.assign(scene.primitive_count(), Status::undecided);
  for (PrimitiveId id = 0; id < scene.triangles().size(); ++id)
    if (const auto witness = random.aim_at(id, rays, 1)) {
      set.set.status[id] = Status::visible;
      set.set.witnesses.push_back(*witness);
    }
  return set;
}

CellOptions rays_alone(int rays) {
  CellOptions o;
  o.pixels = {4, 4};
  o.viewpoints = o.directions = o.path_pixels = 0;
  o.rays = rays;
  return o;
}

}  // namespace

TEST_CASE("what random rays prove is a proof, and is never called hidden") {
  std::size_t found = 0, all = 0;
  for (const std::uint64_t seed : seeds(50)) {
    const Case c = generate(seed);
    Random random(seed + 5);
    const ViewCell cell = any_cell(c, random);
    INFO(describe(c, cell));
    const Scene scene(c.arrays);
    if (lies_on_occluders(scene, cell)) continue;
    const CellSet set = proven(scene, cell, 6);
    REQUIRE(verify_witnesses(scene, cell, set, one_thread()) == set.set.witnesses.size());
    CellOptions options = rays_alone(0);
    options.method = CellMethod::cos;
    const CellSet upper = visible_from_cell(scene, cell, options, one_thread());
    for (const PrimitiveId id : set.set.with(Status::visible))
      REQUIRE(upper.set.status[id] != Status::hidden);
    found += set.set.witnesses.size();
    all += scene.triangles().size();
  }
  CHECK(found > all / 10);
}

TEST_CASE("rays find what is seen from a corner of the cell only, and are told apart from other stages") {
  // A wall with a post behind it, which only viewpoints beside the wall's edge see.
  SceneArrays arrays;
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { add_triangle(arrays, a, b, c); };
  add({-90, -90, -2}, {0.99, -90, -2}, {0.99, 900, -2});
  add({-0.5, -1, -9}, {0.98, -1, -9}, {0.5, 1, -9});
  const Scene scene(arrays);
  const ViewCell cell{{-1, -1, -1}, {1, 1, 1}, {}};
  const CellSet with = visible_from_cell(scene, cell, rays_alone(64));
  CHECK(with.set.status == std::vector<Status>{Status::visible, Status::visible});
  CHECK(verify_witnesses(scene, cell, with) == 2);
  const CellSet again = visible_from_cell(scene, cell, rays_alone(64), one_thread());
  CHECK(again.set.witnesses.size() == 2);
  CHECK(again.bounds.rays == with.bounds.rays);
  // From deep behind the edge nothing of the post is seen, and no ray claims that it is.
  const ViewCell behind{{-1, -1, -1}, {-0.5, 1, 1}, {}};
  const CellSet none = visible_from_cell(scene, behind, rays_alone(1000));
  CHECK(none.set.status[1] != Status::visible);
}

TEST_CASE("rays obey sides, see-through triangles, planes that hold the viewpoint, and the window") {
  SceneArrays arrays;
  arrays.vertices = {{-9, -9, -3}, {9, -9, -3}, {0, 9, -3}, {-90, -90, -5}, {90, -90, -5}, {0, 90, -5}};
  arrays.triangles = {{0, 1, 2}, {3, 4, 5}};
  const ViewCell cell{{-0.25, -0.25, 0}, {0.25, 0.25, 0.25}, {}};
  const auto seen = [&](std::uint8_t front, std::uint8_t back, const ViewCell& where) {
    arrays.triangle_flags = {front, back};
    return proven(Scene(arrays), where, 30).set.with(Status::visible);
  };
  using Ids = std::vector<PrimitiveId>;
  ViewCell small = cell;
  small.window = Frame{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, {-0.01, 0.01, -0.01, 0.01}};
  CHECK(seen(0, 0, cell) == Ids{0, 1});  // round the edges of the nearer one
  CHECK(seen(see_through, 0, cell) == Ids{0, 1});
  std::swap(arrays.triangles[0][0], arrays.triangles[0][1]);
  CHECK(seen(single_sided, 0, cell) == Ids{1});
  small.window->forward = {0, 0, 1};
  small.window->right = {-1, 0, 0};
  CHECK(seen(0, 0, small) == Ids{});
  // A viewpoint on an occluder proves nothing.
  const ViewCell on{{-0.25, -0.25, -3}, {0.25, 0.25, -3}, {}};
  CHECK(seen(0, 0, on) == Ids{});
}

}  // namespace provis::test
