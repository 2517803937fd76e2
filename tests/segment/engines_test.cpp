// Both engines and all certain policies give one answer, on scenes made to be degenerate.

#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/segment/engine_cases.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/transform.hpp"

namespace provis::test {
namespace {

SegmentOptions with(SegmentEngine engine, Arithmetic arithmetic = Arithmetic::chain,
                    std::uint64_t bytes = 0) {
  SegmentOptions options;
  options.engine = engine;
  options.arithmetic = arithmetic;
  options.memory_bytes = bytes;
  return options;
}

}  // namespace

TEST_CASE("the fast engine gives the plain engine's sets, lists and counts") {
  std::size_t visible = 0, boundary = 0;
  for (const std::uint64_t seed : seeds(40)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    const PrintedAnswer plain = answer(scene, c.view, with(SegmentEngine::plain));
    REQUIRE(answer(scene, c.view, with(SegmentEngine::fast)) == plain);
    visible += plain.visible.size();
    boundary += plain.boundary.size();
  }
  WARN(visible << " visible, " << boundary << " of them at the boundary only");
  if (seeds(40).size() > 100) CHECK((boundary > 0 && boundary < visible));
}

TEST_CASE("the engines agree on soups of hundreds of triangles and thousands of pixels") {
  for (const std::uint64_t seed : seeds(1)) {
    const Case c = random_soup(seed, 600);
    INFO("soup " << seed);
    const Scene scene(c.arrays);
    const SegmentView view{c.view.eye, c.view.eye + Vec3d{0.5, -0.25, 1}, c.view.frames, {50, 40}};
    REQUIRE(answer(scene, view, with(SegmentEngine::fast)) ==
            answer(scene, view, with(SegmentEngine::plain)));
  }
}

TEST_CASE("exact numbers throughout give the chain's answer") {
  for (const std::uint64_t seed : seeds(10)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    REQUIRE(answer(scene, c.view, with(SegmentEngine::fast, Arithmetic::exact)) ==
            answer(scene, c.view, with(SegmentEngine::fast)));
  }
}

TEST_CASE("MPFR throughout gives the chain's answer") {
  for (const std::uint64_t seed : seeds(2)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    REQUIRE(answer(scene, c.view, with(SegmentEngine::plain, Arithmetic::mpfr)) ==
            answer(scene, c.view, with(SegmentEngine::plain)));
  }
}

TEST_CASE("a path that is cut in parts to save memory gives the same lists") {
  for (const std::uint64_t seed : seeds(10)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    const PrintedAnswer whole = answer(scene, c.view);
    for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain})
      REQUIRE(answer(scene, c.view, with(engine, Arithmetic::chain, 20000)) == whole);
  }
}

TEST_CASE("plain doubles end on every case, claim nothing, and are sometimes wrong") {
  std::size_t wrong = 0;
  for (const std::uint64_t seed : seeds(20)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    const SegmentSet set =
        visible_from_segment(scene, c.view, with(SegmentEngine::fast, Arithmetic::doubles));
    REQUIRE(set.set.guarantee == Guarantee::sampled);
    wrong += set.set.status != visible_from_segment(scene, c.view).set.status;
  }
  WARN("plain doubles are wrong on " << wrong << " of " << seeds(20).size() << " cases");
  if (seeds(20).size() > 100) CHECK(wrong > 0);
}

TEST_CASE("permuting triangles or corners, or splitting vertices, changes no list") {
  for (const std::uint64_t seed : seeds(4)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const PrintedAnswer original = answer(Scene(c.scene.arrays), c.view);
    REQUIRE(answer(Scene(rotate_corners(c.scene, seed).changed.arrays), c.view) == original);
    REQUIRE(answer(Scene(split_vertices(c.scene).changed.arrays), c.view) == original);
    const Variant permuted = permute_triangles(c.scene, seed);
    const SegmentSet other = visible_from_segment(Scene(permuted.changed.arrays), c.view);
    std::vector<bool> flags;
    for (const Status s : other.set.status) flags.push_back(s == Status::visible);
    const std::vector<bool> back = pull_back(permuted, flags);
    for (std::size_t id = 0; id < back.size(); ++id)
      REQUIRE(back[id] == std::binary_search(original.visible.begin(), original.visible.end(), id));
  }
}

}  // namespace provis::test
