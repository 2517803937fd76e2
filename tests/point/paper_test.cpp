// The paper's engine: the same set by another way, and what it counts on that way.

#include <catch2/catch.hpp>

#include <gmpxx.h>

#include <iostream>

#include "provis/witness.hpp"
#include "tests/point/answers.hpp"
#include "tests/point/hard_case.hpp"
#include "tests/point/named_views.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

PointOptions paper(const PixelGrid& pixels) {
  PointOptions options;
  options.engine = PointEngine::paper;
  options.pixels = pixels;
  return options;
}

VisibleSet ask(const Case& c, const PointOptions& options, int threads = 0) {
  Context context;
  context.threads = threads;
  return visible_from_point(Scene(c.arrays), c.view, options, context);
}

PixelGrid some_grid(std::uint64_t seed) {
  const PixelGrid grids[] = {{1, 1}, {2, 3}, {6, 5}, {16, 9}};
  return grids[seed % 4];
}

void check_counts(const VisibleSet& set) {
  const IterationStats& s = set.stats.iteration;
  REQUIRE(s.aggressive <= s.visible_after_first);
  REQUIRE(s.visible_after_first <= s.visible);
  REQUIRE(s.visible - s.aggressive <= s.undecided);
  REQUIRE(s.undecided_after_first <= s.undecided);
  REQUIRE((s.iterations > 0 || s.undecided_after_first == 0));
  REQUIRE(s.area_missed <= s.area * (1 + 1e-9));
}

}  // namespace

TEST_CASE("the paper's engine gives the oracle's and the default engine's set on every generated case") {
  std::size_t visible = 0, aggressive = 0, subtracted = 0, late = 0;
  for (const std::uint64_t seed : seeds(50)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const VisibleSet set = ask(c, paper(some_grid(seed)));
    REQUIRE(set.guarantee == Guarantee::exact);
    REQUIRE(ids_of(visible_flags(set)) == ids_of(oracle_visible(c.arrays, c.view)));
    REQUIRE(visible_flags(set) == engine_visible(c));
    check_counts(set);
    visible += set.stats.iteration.visible;
    aggressive += set.stats.iteration.aggressive;
    subtracted += set.stats.iteration.subtracted;
    late += set.stats.iteration.undecided_after_first;
  }
  WARN("aggressive " << aggressive << " of " << visible << ", undecided after the first iteration " << late
                     << ", decided by subtraction " << subtracted);
  // Without work for the iterations nothing would be tested.
  if (seeds(50).size() > 100) CHECK((aggressive < visible && late > 0));
}

TEST_CASE("soups of some hundred triangles agree too") {
  for (const std::uint64_t seed : seeds(1)) {
    const Case c = random_soup(seed, 300);
    INFO("soup " << seed);
    REQUIRE(ids_of(visible_flags(ask(c, paper({8, 8})))) == ids_of(oracle_visible(c.arrays, c.view)));
  }
}

TEST_CASE("soups in which much is see-through agree too") {
  for (const std::uint64_t seed : seeds(10)) {
    Case c = random_soup(seed, 40);
    for (std::size_t t = 0; t < c.arrays.triangle_flags.size(); ++t)
      if (t % 5 < 2) c.arrays.triangle_flags[t] |= see_through;
    INFO("soup " << seed);
    REQUIRE(ids_of(visible_flags(ask(c, paper({1, 1})))) == ids_of(oracle_visible(c.arrays, c.view)));
  }
}

TEST_CASE("the paper's engine gives the expected set of every hard case") {
  for (const HardCase& c : load_hard_cases(PROVIS_SOURCE_DIR "/data/hard")) {
    INFO(c.because << "\n" << describe(c.input));
    for (const PixelGrid grid : {PixelGrid{1, 1}, PixelGrid{7, 5}})
      REQUIRE(ask(c.input, paper(grid)).with(Status::visible) == c.visible);
    PointOptions slow = paper({2, 2});
    slow.arithmetic = Arithmetic::exact;
    REQUIRE(ask(c.input, slow).with(Status::visible) == c.visible);
  }
}

TEST_CASE("its witnesses hold, and its subdivision fills the window") {
  for (const std::uint64_t seed : seeds(5)) {
    const Case c = generate(seed);
    INFO(describe(c));
    PointOptions options = paper(some_grid(seed));
    options.witnesses = true;
    options.subdivision = true;
    const VisibleSet set = ask(c, options);
    REQUIRE(visible_flags(set) == engine_visible(c));
    REQUIRE(set.witnesses.size() == set.with(Status::visible).size());
    const RayChecker checker(c.arrays, c.view);
    for (const Witness& w : set.witnesses) REQUIRE(checker.refuse(w) == "");
    mpq_class uncovered = 0;
    for (const Frame& f : c.view.frames)
      uncovered += (mpq_class(f.window.x1) - f.window.x0) * (mpq_class(f.window.y1) - f.window.y0);
    std::vector<bool> seen(set.status.size(), false);
    for (const SubdivisionCell& cell : set.subdivision) {
      uncovered -= mpq_class(cell.area);
      for (const PrimitiveId id : cell.visible) seen[id] = true;
    }
    REQUIRE(uncovered == 0);
    REQUIRE(seen == visible_flags(set));
  }
}

TEST_CASE("threads change nothing of the paper's answer, nor of its counters") {
  for (const int scene : {0, 1}) {
    Case c = random_soup(static_cast<std::uint64_t>(scene) + 31, 1200);
    if (scene == 1) c.view = omni(c.view.eye);
    const VisibleSet one = ask(c, paper({32, 32}), 1);
    CHECK(one.stats.iteration.iterations > 0);
    for (const int threads : {2, 7}) {
      const VisibleSet other = ask(c, paper({32, 32}), threads);
      REQUIRE(one.status == other.status);
      REQUIRE(one.stats.sampling.locations == other.stats.sampling.locations);
      REQUIRE(one.stats.iteration.visible_after_first == other.stats.iteration.visible_after_first);
      REQUIRE(one.stats.iteration.undecided_after_first == other.stats.iteration.undecided_after_first);
      REQUIRE(one.stats.iteration.area_missed == other.stats.iteration.area_missed);
    }
  }
}

TEST_CASE("plain doubles end under the paper's engine, and claim nothing") {
  for (const std::uint64_t seed : seeds(5)) {
    const Case c = generate(seed);
    INFO(describe(c));
    PointOptions options = paper({4, 4});
    options.arithmetic = Arithmetic::doubles;
    REQUIRE(ask(c, options).guarantee == Guarantee::sampled);
  }
}

TEST_CASE("mistakes put into the oracle are noticed by the paper's engine") {
  for (const Plant plant : {Plant::none, Plant::drop_an_occluder, Plant::flip_a_tie}) {
    int noticed = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      const Case c = generate(seed);
      noticed += visible_flags(ask(c, paper({3, 3}))) != oracle_visible(c.arrays, c.view, plant);
    }
    CHECK((noticed > 0) == (plant != Plant::none));
  }
}

TEST_CASE("real views: the paper's engine gives the default engine's set") {
  for (const char* name : {"sponza_dabrovic_a", "vox_monu1", "quake_bsp_dm4", "ifc_duplex"}) {
    const auto file = shared_scene(name);
    if (!file) continue;
    const Scene scene = load_scene(*file);
    for (const NamedView& v : named_views(*file)) {
      INFO(name << ", view " << v.name);
      const VisibleSet set = visible_from_point(scene, v.view, paper({320, 180}));
      CHECK(set.status == visible_from_point(scene, v.view).status);
      check_counts(set);
      std::cout << name << ' ' << v.name << ": " << set.with(Status::visible).size() << " visible, "
                << set.stats.iteration.aggressive << " aggressive, " << set.stats.iteration.iterations
                << " iterations\n";
    }
  }
}

}  // namespace provis::test
