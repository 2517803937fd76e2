// The upper set by a level of detail: nothing that is visible is called hidden, and much that is hidden is.

#include <catch2/catch.hpp>

#include "provis/cell.hpp"
#include "src/region/covered_cell.hpp"
#include "tests/lod/detail_case.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"

namespace provis::test {
namespace {

/// The scenes of a case, and their level of detail.
struct Loaded {
  Scene full, occluders, shell;
  LevelOfDetail detail;

  explicit Loaded(const DetailCase& c)
      : full(c.full.arrays),
        occluders(c.occluders),
        shell(c.shell),
        detail({&full, "full"}, {&occluders, "occluders"}, {&shell, "shell"}, c.objects, one_thread()) {}

  CellSet look(const ViewCell& cell, CellMethod method, bool simplified) const {
    CellOptions o = small_options(method, 4, 0);  // the lower set alone aims no rays
    if (simplified) o.detail = &detail;
    return visible_from_cell(full, cell, o, one_thread());
  }
};

/// A small cell on the lattice of the objects, or one of all kinds.
ViewCell near_cell(const DetailCase& c, Random& random) {
  if (random.chance(40)) return any_cell(c.full, random);
  const Vec3d edges{random.pick({0.0, 0.5, 1.0}), random.pick({0.5, 1.0}), random.pick({0.5, 1.0, 2.0})};
  return cell_around(c.full.view.eye, edges);
}

}  // namespace

TEST_CASE("nothing that a ray out of the cell sees is hidden by a level of detail") {
  std::uint64_t hidden = 0, undecided = 0, whole = 0, dropped = 0, candidates = 0, objects = 0;
  std::size_t proven = 0;
  for (const std::uint64_t seed : seeds(6)) {
    const DetailCase c = detail_case(seed);
    Random random(seed + 77);
    const ViewCell cell = near_cell(c, random);
    INFO(describe(c.full, cell));
    const Loaded loaded(c);
    if (lies_on_occluders(loaded.full, cell)) continue;
    const CellSet upper = loaded.look(cell, CellMethod::cos, true);
    const CellRays rays(c.full.arrays, cell);
    constexpr int tries = 40;
    for (int k = 0; k < tries; ++k) {
      const std::vector<PrimitiveId> seen = rays.seen(random);
      proven += seen.size();
      REQUIRE(hidden_among(upper, seen) == std::vector<PrimitiveId>{});
    }
    if (cell.lower == cell.upper) continue;
    hidden += upper.bounds.hidden;
    undecided += upper.bounds.undecided;
    whole += upper.detail.whole;
    dropped += upper.detail.dropped;
    candidates += upper.detail.candidates;
    objects += upper.detail.objects;
  }
  WARN(proven << " sights; " << hidden << " hidden, " << undecided << " not; of " << objects << " objects "
              << candidates << " candidates, " << whole << " as a whole, " << dropped << " hide nothing");
  if (seeds(6).size() > 100) {
    CHECK(proven > seeds(6).size());
    CHECK(candidates > whole);
    CHECK(objects > candidates);
    CHECK(dropped > 0);
  }
}

TEST_CASE("bounds with a level of detail hold what is visible, and agree with what the full scene hides") {
  for (const std::uint64_t seed : seeds(3)) {
    const DetailCase c = detail_case(seed);
    Random random(seed + 77);
    const ViewCell cell = near_cell(c, random);
    INFO(describe(c.full, cell));
    const Loaded loaded(c);
    if (lies_on_occluders(loaded.full, cell)) continue;
    const CellSet lower = loaded.look(cell, CellMethod::lower, false);
    const CellSet upper = loaded.look(cell, CellMethod::cos, true);
    REQUIRE(hidden_among(upper, lower.set.with(Status::visible)) == std::vector<PrimitiveId>{});
    const CellSet bounds = loaded.look(cell, CellMethod::bounds, true);
    REQUIRE(bounds.set.with(Status::visible) == lower.set.with(Status::visible));
    // What is settled before any ray is looked at is asked for no less.
    for (PrimitiveId id = 0; id < bounds.set.status.size(); ++id)
      if (bounds.set.status[id] == Status::hidden) REQUIRE(upper.set.status[id] == Status::hidden);
  }
}

/// A wall as a thin box of many triangles, and a ball behind it.
DetailCase wall_and_ball() {
  Random random(1);
  DetailCase c;
  const SolidBox wall{{-8, -8, -5}, {8, 8, -4}};
  add(c, "wall",
      {box_solid(wall, 3, random), box_solid({{-8, -8, -4.75}, {8, 8, -4.25}}),
       box_solid({{-9, -9, -6}, {9, 9, -3}}), single_sided});
  add(c, "ball", {ball({0, 0, -12}, 2, 2), {}, octahedron({0, 0, -12}, 4), 0});
  return c;
}

const ViewCell before_the_wall{{-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, {}};

TEST_CASE("a ball behind a wall is hidden by the wall's occluders alone") {
  const DetailCase c = wall_and_ball();
  const Loaded loaded(c);
  const CellSet set = loaded.look(before_the_wall, CellMethod::cos, true);
  const IdRange ball_ids = c.objects[1].full[0];
  for (PrimitiveId id = ball_ids.first; id <= ball_ids.last; ++id)
    CHECK(set.set.status[id] == Status::hidden);
  CHECK(set.bounds.undecided > 0);
  CHECK(set.detail.objects == 2);
  CHECK(set.detail.candidates == 1);
  CHECK(set.detail.whole == 0);
  CHECK(set.detail.dropped == 0);
  CHECK(set.detail.triangles == 12 + 12 + 8);
}

TEST_CASE("an object that shows is a candidate as a whole, back faces and all") {
  DetailCase c = wall_and_ball();
  c.objects.erase(c.objects.begin());
  c.occluders = {};
  c.shell = {};
  add(c.shell, octahedron({0, 0, -12}, 4), 0);
  c.objects[0].shell = {{0, 7}};
  const Loaded loaded(c);
  // The wall's triangles stand for themselves now.
  const CellSet set = loaded.look(before_the_wall, CellMethod::cos, true);
  CHECK(set.detail.candidates == 0);
  const CellSet behind = loaded.look({{-0.5, -0.5, -8.5}, {0.5, 0.5, -7.5}, {}}, CellMethod::cos, true);
  CHECK(behind.detail.candidates == 1);
  CHECK(behind.detail.whole == 1);  // the octahedron's tip
  const CellSet near = loaded.look({{-0.25, -0.25, -7.5}, {0.25, 0.25, -7.25}, {}}, CellMethod::cos, true);
  CHECK(near.detail.candidates == 1);
  CHECK(near.detail.whole == 0);
  const IdRange ids = c.objects[0].full[0];
  std::size_t undecided = 0;
  for (PrimitiveId id = ids.first; id <= ids.last; ++id)
    undecided += near.set.status[id] == Status::undecided;
  CHECK(undecided == ids.last - ids.first + 1);
}

TEST_CASE("a cell inside of a shell, in a solid and in a cavity") {
  DetailCase c;
  const SolidBox outer{{-4, -4, -4}, {4, 4, 4}}, cavity{{-2, -2, -2}, {2, 2, 2}};
  add(c, "hollow",
      {joined(box_solid(outer), reversed(box_solid(cavity))), octahedron({3, 3, 3}, 0.5), box_solid(outer),
       single_sided});
  add(c, "apart", {ball({0, 0, -12}, 2, 1), {}, box_solid({{-2, -2, -14}, {2, 2, -10}}), 0});
  const Loaded loaded(c);
  const auto look = [&](const Vec3d& center) {
    return loaded.look(cell_around(center, {0.5, 0.5, 0.5}), CellMethod::cos, true);
  };
  const CellSet in_cavity = look({0, 0, 0});
  CHECK(in_cavity.detail.whole == 1);
  CHECK(in_cavity.detail.dropped == 0);  // the cavity is outside of what its triangles enclose
  const CellSet in_wall = look({3, 0, 0});
  CHECK(in_wall.detail.whole == 1);
  CHECK(in_wall.detail.dropped == 1);
  const CellSet outside = look({7, 0, 0});
  CHECK(outside.detail.whole == 0);
  CHECK(outside.detail.dropped == 0);
  // Touching is not outside.
  CHECK(look({4.25, 0, 0}).detail.whole == 1);
  CHECK(look({4.25, 0, 0}).detail.dropped == 1);
}

TEST_CASE("threads change nothing of a level of detail") {
  const DetailCase c = detail_case(7);
  Random random(7);
  const ViewCell cell = any_cell(c.full, random);
  const Loaded loaded(c);
  CellOptions o;
  o.detail = &loaded.detail;
  o.viewpoints = 2;
  const CellSet one = visible_from_cell(loaded.full, cell, o, one_thread());
  Context many;
  many.threads = 7;
  const CellSet seven = visible_from_cell(loaded.full, cell, o, many);
  CHECK(one.set.status == seven.set.status);
  CHECK(one.detail.candidates == seven.detail.candidates);
  CHECK(one.offset.beams == seven.offset.beams);
}

}  // namespace provis::test
