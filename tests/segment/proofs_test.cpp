// Witnesses along a segment: they hold, there is one for each primitive of R10°, and damaged ones are
// refused.

#include <catch2/catch.hpp>

#include <atomic>

#include "provis/error.hpp"
#include "provis/witness.hpp"
#include "tests/segment/engine_cases.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {
namespace {

SegmentSet proven(const Scene& scene, const SegmentView& view, int threads = 0,
                  SegmentEngine engine = SegmentEngine::fast) {
  SegmentOptions options;
  options.witnesses = true;
  options.engine = engine;
  Context context;
  context.threads = threads;
  return visible_from_segment(scene, view, options, context);
}

std::string text(const SegmentSet& set) {
  std::string all;
  const auto add = [&](const Dyadic& d) { all += d.mantissa + "*2^" + std::to_string(d.exponent) + " "; };
  for (const Witness& w : set.set.witnesses) {
    all += std::to_string(w.primitive) + ": ";
    for (const Vec3<Dyadic>& v : {w.origin, w.direction}) {
      add(v.x);
      add(v.y);
      add(v.z);
    }
  }
  return all;
}

bool refused(const Scene& scene, const SegmentView& view, const SegmentSet& set) {
  try {
    verify_witnesses(scene, view, set);
  } catch (const Error& e) {
    return e.code() == Error::Code::rejected;
  }
  return false;
}

}  // namespace

TEST_CASE("every primitive of R10° has a witness that holds") {
  std::size_t held = 0;
  for (const std::uint64_t seed : seeds(10)) {
    const EngineCase c = generate_engine_case(seed);
    INFO(describe(c));
    const Scene scene(c.scene.arrays);
    const SegmentSet set = proven(scene, c.view);
    REQUIRE(set.set.witnesses.size() + set.boundary.size() == set.set.with(Status::visible).size());
    REQUIRE(verify_witnesses(scene, c.view, set) == set.set.witnesses.size());
    REQUIRE(text(proven(scene, c.view, 0, SegmentEngine::plain)) == text(set));
    held += set.set.witnesses.size();
  }
  CHECK(held > 0);
}

TEST_CASE("damaged witnesses are refused") {
  const Case c = random_soup(3, 40);
  const Scene scene(c.arrays);
  const SegmentView view{c.view.eye, c.view.eye + Vec3d{0.5, 0.25, 0}, c.view.frames, {16, 12}};
  const SegmentSet good = proven(scene, view);
  REQUIRE(good.set.witnesses.size() > 1);
  CHECK_FALSE(refused(scene, view, good));
  SegmentSet other_target = good;
  std::swap(other_target.set.witnesses[0].primitive, other_target.set.witnesses[1].primitive);
  CHECK(refused(scene, view, other_target));
  SegmentSet moved = good;
  moved.set.witnesses[0].origin.z = {"12345", 0};
  CHECK(refused(scene, view, moved));
  SegmentSet turned = good;
  turned.set.witnesses[0].direction.x = {"1", -70};
  CHECK(refused(scene, view, turned));
  SegmentSet fewer = good;
  fewer.set.witnesses.pop_back();
  CHECK(refused(scene, view, fewer));
  fewer.boundary = {good.set.witnesses.back().primitive};
  CHECK_FALSE(refused(scene, view, fewer));
}

TEST_CASE("a witness may not start on an occluder") {
  SceneArrays arrays;
  arrays.vertices = {{-90, -90, -4}, {90, -90, -4}, {0, 90, -4}, {-9, 0, 3}, {9, 0, 3}, {0, 0, -3}};
  arrays.triangles = {{0, 1, 2}, {3, 4, 5}};
  arrays.triangle_flags = {0, 0};
  const Scene scene(arrays);
  const SegmentView view{{-1, 0, 0}, {1, 0, 0}, {Frame{}}, {1, 1}};
  SegmentSet set = proven(scene, view);
  REQUIRE(set.boundary == std::vector<PrimitiveId>{0});
  set.boundary.clear();
  set.set.witnesses = {{0, {{"0", 0}, {"0", 0}, {"0", 0}}, {{"0", 0}, {"0", 0}, {"-1", 0}}}};
  CHECK(refused(scene, view, set));
}

TEST_CASE("1, 2 and 7 threads give the same lists, measures and witnesses") {
  const Case c = random_soup(11, 800);
  const Scene scene(c.arrays);
  const SegmentView view{c.view.eye, c.view.eye + Vec3d{0.5, 0.25, 0}, c.view.frames, {70, 50}};
  const auto run = [&](int threads) {
    Context context;
    context.threads = threads;
    return answer(scene, view, {}, context);
  };
  const PrintedAnswer one = run(1);
  CHECK(run(2) == one);
  CHECK(run(7) == one);
  const SegmentSet first = proven(scene, view, 1), other = proven(scene, view, 7);
  CHECK(text(first) == text(other));
  REQUIRE(first.seen.size() == other.seen.size());
  for (std::size_t k = 0; k < first.seen.size(); ++k) CHECK(first.seen[k].length == other.seen[k].length);
}

TEST_CASE("a cancelled segment query throws, and progress ends at its total") {
  const Case c = random_soup(5, 300);
  const Scene scene(c.arrays);
  const SegmentView view{c.view.eye, c.view.eye + Vec3d{0.5, 0.25, 0}, c.view.frames, {40, 30}};
  Context context;
  double last = 0, total = 0;
  bool monotone = true;
  context.on_progress = [&](const Progress& p) {
    monotone &= p.done >= last;
    last = p.done;
    total = p.total;
  };
  visible_from_segment(scene, view, {}, context);
  CHECK(monotone);
  CHECK(last == total);
  std::atomic<bool> cancel{true};
  context.cancel = &cancel;
  try {
    visible_from_segment(scene, view, {}, context);
    FAIL("was not cancelled");
  } catch (const Error& e) {
    CHECK(e.code() == Error::Code::cancelled);
  }
}

}  // namespace provis::test
