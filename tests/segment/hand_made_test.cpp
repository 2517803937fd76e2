// What the header promises, on scenes small enough to say the answer at once.

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

#include "provis/error.hpp"
#include "tests/segment/answers.hpp"

namespace provis::test {
namespace {

using Ids = std::vector<PrimitiveId>;

/// Triangle 0 covers x <= 1/2 at z = -2, triangle 1 is a wall at z = -4; the camera goes from x = 0 to 1.
SegmentCase half_a_wall() {
  SegmentCase c;
  SceneArrays& scene = c.start.arrays;
  scene.vertices = {{0.5, -9, -2}, {0.5, 9, -2}, {-9, 0, -2}, {-9, -9, -4}, {9, -9, -4}, {0, 9, -4}};
  scene.triangles = {{0, 1, 2}, {3, 4, 5}};
  scene.triangle_flags = {0, 0};
  c.start.view.frames = {Frame{}};
  c.to = {1, 0, 0};
  c.pixels = {1, 1};
  return c;
}

/// The code with which a query ends; fails if it does not end that way.
template <class Query>
Error::Code code_of(const Query& query) {
  try {
    query();
  } catch (const Error& e) {
    CHECK(std::string(e.what()).size() > 10);
    return e.code();
  }
  FAIL("nothing was thrown");
  return {};
}

Error::Code refusal(const SegmentView& view) {
  const Error::Code said = code_of([&] { check(view); });
  CHECK(code_of([&] { visible_from_segment(Scene(half_a_wall().start.arrays), view); }) == said);
  return said;
}

}  // namespace

TEST_CASE("an answer along a segment says what it is") {
  SegmentSet set;
  const Answer answer = engine_answer(half_a_wall(), {}, {}, &set);
  CHECK(set.set.answers == "R10");
  CHECK(set.set.guarantee == Guarantee::exact);
  CHECK(set.set.status == std::vector<Status>{Status::visible, Status::visible});
  CHECK(set.set.witnesses.empty());
  REQUIRE(set.seen.size() == 2);
  for (const Seen& s : set.seen) {
    CHECK(s.pixels == 1);
    CHECK(s.length == 0.5);
  }
}

TEST_CASE("times are written as fractions in lowest terms") {
  SegmentOptions options;
  std::vector<PixelSights> told;
  options.on_pixel = [&](const PixelSights& p) { told.push_back(p); };
  const SegmentCase c = half_a_wall();
  visible_from_segment(Scene(c.start.arrays), c.view(), options);
  REQUIRE(told.size() == 1);
  REQUIRE(told[0].sights.size() == 2);
  CHECK(told[0].sights[0].from == "0/1");
  CHECK(told[0].sights[0].to == "1/2");
  CHECK(told[0].sights[1].from == "1/2");
  CHECK(told[0].sights[1].to == "1/1");
  CHECK(told[0].sights[0].visible == Ids{0});
  CHECK(told[0].sights[1].visible == Ids{1});
}

TEST_CASE("pixels are told in order of frame, row and column, whatever the thread count") {
  SegmentCase c = half_a_wall();
  c.start.view.frames = omni(c.start.view.eye).frames;
  c.pixels = {37, 23};
  for (const int threads : {1, 4}) {
    Context context;
    context.threads = threads;
    const Answer answer = engine_answer(c, {}, context);
    REQUIRE(answer.pixels.size() == 6 * 37 * 23);
    std::size_t i = 0;
    bool in_order = true;
    for_pixels(c.view(), [&](const Pixel& p) {
      const ExactSights& told = answer.pixels[i++];
      in_order = in_order && told.frame == p.frame && told.column == p.column && told.row == p.row;
    });
    CHECK(in_order);
  }
}

TEST_CASE("a scene without triangles shows background") {
  SegmentCase c = half_a_wall();
  c.start.arrays = {};
  const Answer answer = engine_answer(c);
  CHECK(answer.visible.empty());
  CHECK(answer.pixels == std::vector<ExactSights>{{0, 0, 0, {{0, 1, {}}}}});
}

TEST_CASE("the same frame twice counts each pixel twice and changes no set") {
  SegmentCase c = half_a_wall();
  c.start.view.frames.push_back(c.start.view.frames.front());
  SegmentSet set;
  const Answer answer = engine_answer(c, {}, {}, &set);
  CHECK(answer.visible == Ids{0, 1});
  REQUIRE(set.seen.size() == 2);
  CHECK(set.seen[0].pixels == 2);
  CHECK(set.seen[1].length == 1);
}

TEST_CASE("a segment or a frame that makes no sense is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SegmentView good = half_a_wall().view();
  CHECK_NOTHROW(check(good));
  const auto refused = [&](const auto& spoil) {
    SegmentView view = good;
    spoil(view);
    return refusal(view) == Error::Code::usage;
  };
  CHECK(refused([&](SegmentView& v) { v.from.y = nan; }));
  CHECK(refused([&](SegmentView& v) { v.to.z = HUGE_VAL; }));
  CHECK(refused([&](SegmentView& v) { v.frames.clear(); }));
  CHECK(refused([&](SegmentView& v) { v.frames[0].up = v.frames[0].right; }));
  CHECK(refused([&](SegmentView& v) { v.frames[0].forward = {1e-320, 0, 0}; }));
  CHECK(refused([&](SegmentView& v) { v.frames[0].right.x = nan; }));
  CHECK(refused([&](SegmentView& v) { v.frames[0].window.x1 = v.frames[0].window.x0; }));
  CHECK(refused([&](SegmentView& v) { v.frames[0].window.y0 = HUGE_VAL; }));
  CHECK(refused([&](SegmentView& v) { v.pixels.width = 0; }));
  CHECK(refused([&](SegmentView& v) { v.pixels.height = 16385; }));
  CHECK(refused([&](SegmentView& v) { v.pixels.height = -1; }));
  CHECK(refused([&](SegmentView& v) { v.frames.push_back({{1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {}}); }));
}

TEST_CASE("frame vectors of any size and nearly dependent ones are taken") {
  SegmentView view = half_a_wall().view();
  view.frames[0].forward = {0, 0, -5e-324};
  CHECK_NOTHROW(check(view));
  view.frames[0].forward = {0, 0, -1e308};
  CHECK_NOTHROW(check(view));
  view.frames[0].up = {1, 0x1p-1074, 0};
  CHECK_NOTHROW(check(view));
  view.to = view.from;
  CHECK_NOTHROW(check(view));
}

TEST_CASE("spheres along a segment are not supported, and that is said") {
  SceneArrays arrays = half_a_wall().start.arrays;
  arrays.spheres.push_back({{0, 0, -3}, 1});
  arrays.sphere_flags.push_back(0);
  const Scene scene(arrays);
  CHECK(code_of([&] { visible_from_segment(scene, half_a_wall().view()); }) == Error::Code::unsupported);
}

TEST_CASE("plain doubles give no witnesses along a segment") {
  SegmentOptions options;
  options.arithmetic = Arithmetic::doubles;
  options.witnesses = true;
  const Scene scene(half_a_wall().start.arrays);
  CHECK(code_of([&] { visible_from_segment(scene, half_a_wall().view(), options); }) == Error::Code::usage);
}

}  // namespace provis::test
