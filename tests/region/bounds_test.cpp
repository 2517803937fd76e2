// Lower set, truth and upper set, in this order, on scenes made to be degenerate.

#include <catch2/catch.hpp>

#include "provis/cell.hpp"
#include "provis/witness.hpp"
#include "src/region/cell_paths.hpp"
#include "src/region/covered_cell.hpp"
#include "src/region/lower.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"

namespace provis::test {
namespace {

CellOptions small(CellMethod method) { return small_options(method, 2, 64); }

}  // namespace

TEST_CASE("nothing that an exact ray out of the cell sees is called hidden") {
  std::size_t rays = 0, proven = 0, hidden = 0, undecided = 0;
  for (const std::uint64_t seed : seeds(50)) {
    const Case c = generate(seed);
    Random random(seed + 77);
    const ViewCell cell = any_cell(c, random);
    INFO(describe(c, cell));
    const Scene scene(c.arrays);
    const CellRays oracle(c.arrays, cell);
    constexpr int tries = 60;
    if (lies_on_occluders(scene, cell)) {
      for (int k = 0; k < tries; ++k) REQUIRE(oracle.seen(random).empty());
      continue;
    }
    const CellSet upper = visible_from_cell(scene, cell, small(CellMethod::cos), one_thread());
    for (int k = 0; k < tries; ++k) {
      const std::vector<PrimitiveId> seen = oracle.seen(random);
      ++rays;
      proven += seen.size();
      REQUIRE(hidden_among(upper, seen) == std::vector<PrimitiveId>{});
    }
    hidden += upper.bounds.hidden;
    undecided += upper.bounds.undecided;
  }
  WARN(rays << " rays proved " << proven << " sights; " << hidden << " hidden, " << undecided
            << " not proven hidden");
  // An upper set that holds everything would pass too, and so would rays that see nothing.
  if (seeds(50).size() > 100) {
    CHECK(proven > rays / 4);
    CHECK(4 * hidden > undecided);
  }
}

TEST_CASE("nothing that is visible from a point of the cell is called hidden") {
  for (const std::uint64_t seed : seeds(30)) {
    const Case c = generate(seed);
    Random random(seed + 77);
    ViewCell cell = any_cell(c, random);
    INFO(describe(c, cell));
    const Scene scene(c.arrays);
    if (lies_on_occluders(scene, cell)) continue;
    const CellSet upper = visible_from_cell(scene, cell, small(CellMethod::cos), one_thread());
    CellOptions lower_only = small(CellMethod::lower);
    lower_only.viewpoints = 8;
    const CellSet lower = visible_from_cell(scene, cell, lower_only, one_thread());
    REQUIRE(hidden_among(upper, lower.set.with(Status::visible)) == std::vector<PrimitiveId>{});
  }
}

TEST_CASE("every primitive of the lower set has a witness that holds") {
  std::uint64_t touching = 0, unwitnessed = 0;
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    Random random(seed + 77);
    const ViewCell cell = any_cell(c, random);
    INFO(describe(c, cell));
    const Scene scene(c.arrays);
    if (lies_on_occluders(scene, cell)) continue;
    const CellSet set = visible_from_cell(scene, cell, small(CellMethod::bounds), one_thread());
    REQUIRE(verify_witnesses(scene, cell, set) ==
            set.set.with(Status::visible).size() - set.unwitnessed.size());
    touching += set.bounds.touching;
    unwitnessed += set.bounds.unwitnessed;
  }
  WARN(touching << " triangles meet their cell, " << unwitnessed << " of them without a witness");
}

TEST_CASE("samples of the offset space alone prove what they find") {
  std::size_t found = 0;
  for (const std::uint64_t seed : seeds(5)) {
    const Case c = generate(seed);
    Random random(seed + 77);
    const ViewCell cell = any_cell(c, random);
    INFO(describe(c, cell));
    const Scene scene(c.arrays);
    const Context context = one_thread();
    LowerSet lower(scene, cell, context);
    ProgressMeter meter(context, 1);
    std::uint64_t samples = 0;
    found += lower.look_along(3, samples, meter);
    CellSet claimed;
    claimed.set.status.assign(scene.primitive_count(), Status::undecided);
    for (const auto& w : lower.witnesses()) {
      if (!w) continue;
      claimed.set.status[w->primitive] = Status::visible;
      claimed.set.witnesses.push_back(*w);
    }
    REQUIRE(verify_witnesses(scene, cell, claimed) == claimed.set.witnesses.size());
  }
  CHECK(found > 0);
}

/// A wall at z = -2 with a hole of a tenth around (1, -0.5), and a triangle far behind it that is seen
/// through the hole from the neighbourhood of (0.5, -1, -1), on an edge of the cell, and from no corner.
SceneArrays slit() {
  SceneArrays scene;
  const auto add_rectangle = [&](double x0, double x1, double y0, double y1) {
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    for (const auto& [x, y] : {std::pair(x0, y0), {x1, y0}, {x1, y1}, {x0, y1}})
      scene.vertices.push_back({x, y, -2});
    scene.triangles.push_back({first, first + 1, first + 2});
    scene.triangles.push_back({first, first + 2, first + 3});
  };
  add_rectangle(-64, 64, -64, -0.55);
  add_rectangle(-64, 64, -0.45, 64);
  add_rectangle(-64, 0.95, -0.55, -0.45);
  add_rectangle(1.05, 64, -0.55, -0.45);
  const auto first = static_cast<std::uint32_t>(scene.vertices.size());
  for (const Vec3d& p : {Vec3d{4.9, 3.4, -10}, {5.1, 3.4, -10}, {5, 3.7, -10}}) scene.vertices.push_back(p);
  scene.triangles.push_back({first, first + 1, first + 2});
  scene.triangle_flags.assign(scene.triangles.size(), 0);
  return scene;
}

TEST_CASE("along an edge of the cell is seen what no corner and no middle shows") {
  const Scene scene(slit());
  const auto target = static_cast<PrimitiveId>(scene.triangles().size() - 1);
  const ViewCell cell{{-1, -1, -1}, {1, 1, 1}, {}};
  CellOptions options;
  options.method = CellMethod::lower;
  options.viewpoints = options.directions = options.path_pixels = 0;
  CHECK(visible_from_cell(scene, cell, options).set.status[target] == Status::undecided);
  options.path_pixels = 2;
  const CellSet set = visible_from_cell(scene, cell, options);
  CHECK(set.set.status[target] == Status::visible);
  CHECK(set.bounds.paths == 1);
  CHECK(set.bounds.paths_used == 16);
  CHECK(verify_witnesses(scene, cell, set) == set.set.with(Status::visible).size());
}

TEST_CASE("edges and diagonals of a cell, each once") {
  CHECK(edges_and_diagonals({{0, 0, 0}, {1, 1, 1}, {}}).size() == 16);
  CHECK(edges_and_diagonals({{0, 0, 0}, {1, 1, 0}, {}}).size() == 6);
  CHECK(edges_and_diagonals({{0, 0, 0}, {0, 1, 0}, {}}).size() == 1);
  CHECK(edges_and_diagonals({{0, 0, 0}, {0, 0, 0}, {}}).empty());
}

TEST_CASE("a cell of one point answers as the point does") {
  for (const std::uint64_t seed : seeds(5)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const ViewCell cell{c.view.eye, c.view.eye, {}};
    const CellSet set = visible_from_cell(Scene(c.arrays), cell, {}, one_thread());
    const std::vector<bool> expected = oracle_visible(c.arrays, omni(c.view.eye));
    for (std::size_t t = 0; t < expected.size(); ++t)
      REQUIRE((set.set.status[t] == Status::visible) == expected[t]);
    REQUIRE(set.set.guarantee == Guarantee::exact);
    REQUIRE(verify_witnesses(Scene(c.arrays), cell, set) == set.set.witnesses.size());
  }
}

}  // namespace provis::test
