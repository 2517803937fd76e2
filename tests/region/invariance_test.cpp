// What must hold between answers: nested cells, mirrored and permuted axes, any number of threads.

#include <catch2/catch.hpp>

#include "provis/cell.hpp"
#include "src/region/covered_cell.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/transform.hpp"

namespace provis::test {
namespace {

CellOptions small(CellMethod method) { return small_options(method, 4, 64); }

CellSet ask(const Case& c, const ViewCell& cell, CellMethod method, int threads = 1) {
  Context context;
  context.threads = threads;
  return visible_from_cell(Scene(c.arrays), cell, small(method), context);
}

std::vector<PrimitiveId> seen_from(const Case& c, const ViewCell& cell) {
  return ask(c, cell, CellMethod::lower).set.with(Status::visible);
}

}  // namespace

TEST_CASE("what is seen from a cell is not hidden from a cell around it") {
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    Random random(seed + 5);
    const ViewCell inner = any_cell(c, random);
    const Vec3d more = 0.5 * (inner.upper - inner.lower);
    ViewCell outer = inner;
    outer.upper = inner.upper + more;
    if (random.chance(50)) outer.lower = inner.lower - more;
    INFO(describe(c, inner));
    if (lies_on_occluders(Scene(c.arrays), inner)) continue;
    const CellSet upper = ask(c, outer, CellMethod::cos);
    for (const PrimitiveId id : seen_from(c, inner)) REQUIRE(upper.set.status[id] != Status::hidden);
  }
}

TEST_CASE("what is seen is not hidden after axes are permuted or mirrored") {
  for (const std::uint64_t seed : seeds(10)) {
    const Case c = generate(seed);
    Random random(seed + 5);
    ViewCell cell = any_cell(c, random);
    cell.window.reset();
    INFO(describe(c, cell));
    if (lies_on_occluders(Scene(c.arrays), cell)) continue;
    const std::vector<PrimitiveId> seen = seen_from(c, cell);

    const CellSet turned =
        ask(permute_axes(c, {2, 0, 1}).changed,
            {{cell.lower.z, cell.lower.x, cell.lower.y}, {cell.upper.z, cell.upper.x, cell.upper.y}, {}},
            CellMethod::cos);
    const CellSet mirrored =
        ask(mirror(c, 1).changed,
            {{cell.lower.x, -cell.upper.y, cell.lower.z}, {cell.upper.x, -cell.lower.y, cell.upper.z}, {}},
            CellMethod::cos);
    for (const PrimitiveId id : seen) {
      REQUIRE(turned.set.status[id] != Status::hidden);
      REQUIRE(mirrored.set.status[id] != Status::hidden);
    }
  }
}

TEST_CASE("any number of threads gives the same statuses, witnesses and counters") {
  for (const std::uint64_t seed : seeds(2)) {
    const Case c = generate(seed);
    Random random(seed + 5);
    const ViewCell cell = any_cell(c, random);
    INFO(describe(c, cell));
    if (lies_on_occluders(Scene(c.arrays), cell)) continue;
    const CellSet one = ask(c, cell, CellMethod::bounds, 1);
    for (const int threads : {2, 7}) {
      const CellSet many = ask(c, cell, CellMethod::bounds, threads);
      REQUIRE(many.set.status == one.set.status);
      REQUIRE(many.set.witnesses.size() == one.set.witnesses.size());
      for (std::size_t k = 0; k < one.set.witnesses.size(); ++k) {
        REQUIRE(many.set.witnesses[k].primitive == one.set.witnesses[k].primitive);
        REQUIRE(many.set.witnesses[k].direction.x.mantissa == one.set.witnesses[k].direction.x.mantissa);
      }
      REQUIRE(many.offset.beams == one.offset.beams);
      REQUIRE(many.offset.list_entries == one.offset.list_entries);
    }
  }
}

}  // namespace provis::test
