// Lists worked out by hand: who is seen from when to when, at one pixel's centre.

#include <catch2/catch.hpp>

#include <cmath>

#include "provis/error.hpp"
#include "tests/segment/engine_cases.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

struct HandMade {
  SceneArrays arrays;
  SegmentView view{{-1, 0, 0}, {1, 0, 0}, {Frame{}}, {1, 1}};

  HandMade& add(const Vec3d& a, const Vec3d& b, const Vec3d& c, std::uint8_t flags = 0) {
    add_triangle(arrays, a, b, c, flags);
    return *this;
  }
  /// Across the view at this z.
  HandMade& wall(double z, std::uint8_t flags = 0) {
    return add({-90, -90, z}, {90, -90, z}, {0, 90, z}, flags);
  }
  HandMade& along(const Vec3d& from, const Vec3d& to) {
    view.from = from;
    view.to = to;
    return *this;
  }

  /// Of the one pixel; both engines and two policies have to agree.
  std::string list() const {
    const std::string first = answer(Scene(arrays), view).sights.at(0);
    for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain})
      for (const Arithmetic arithmetic : {Arithmetic::chain, Arithmetic::exact}) {
        SegmentOptions options;
        options.engine = engine;
        options.arithmetic = arithmetic;
        REQUIRE(answer(Scene(arrays), view, options).sights.at(0) == first);
      }
    return first.substr(std::string("0 0 0: ").size());
  }
  std::vector<PrimitiveId> boundary() const { return answer(Scene(arrays), view).boundary; }
};

using Ids = std::vector<PrimitiveId>;

}  // namespace

TEST_CASE("a post passes before a wall") {
  HandMade h;
  h.wall(-4).add({-0.25, -1, -2}, {0.25, -1, -2}, {0, 1, -2});
  CHECK(h.list() == "[0/1 7/16] 0 [7/16 9/16] 1 [9/16 1/1] 0");
  CHECK(h.boundary() == Ids{});
}

TEST_CASE("interpenetrating triangles change places where their planes cross") {
  HandMade h;
  h.add({-8, -9, -11}, {8, -9, 5}, {0, 9, -3})
      .add({-8, -9, 13}, {8, -9, -19}, {0, 9, -3})
      .along({-1, 0, 0}, {2, 0, 0});
  CHECK(h.list() == "[0/1 1/3] 1 [1/3 1/1] 0");
}

TEST_CASE("the camera passes through a triangle") {
  HandMade h;
  h.wall(-3).wall(-8).along({0, 0, 0}, {0, 0, -4});
  CHECK(h.list() == "[0/1 3/4] 0 [3/4 1/1] 1");
}

TEST_CASE("nothing there is a sight of nothing") { CHECK(HandMade().list() == "[0/1 1/1]"); }

TEST_CASE("coincident triangles are all visible, and what is see-through hides nothing") {
  HandMade h;
  h.wall(-4).wall(-4).wall(-2, see_through).wall(-6, see_through);
  CHECK(h.list() == "[0/1 1/1] 0 1 2");
  CHECK(h.boundary() == Ids{});
}

TEST_CASE("a single-sided triangle seen from behind is not there") {
  HandMade h;
  h.wall(-4).add({90, -90, -2}, {-90, -90, -2}, {0, 90, -2}, single_sided);
  CHECK(h.list() == "[0/1 1/1] 0");
}

TEST_CASE("both neighbours of an edge in the pixel's plane are visible, and prove nothing") {
  HandMade h;
  h.add({-9, 0, -4}, {9, 0, -4}, {0, 9, -4}).add({9, 0, -4}, {-9, 0, -4}, {0, -9, -4});
  CHECK(h.list() == "[0/1 1/1] 0 1");
  CHECK(h.boundary() == Ids{0, 1});
}

TEST_CASE("a triangle whose plane holds the segment has no hits") {
  HandMade h;
  h.wall(-4).add({-9, 0, -1}, {9, 0, -1}, {0, 0, -3});
  CHECK(h.list() == "[0/1 1/1] 0");
  CHECK(h.boundary() == Ids{});
}

TEST_CASE("what is seen only from viewpoints on an occluder is not proven") {
  HandMade h;
  h.wall(-4).add({-9, 0, 3}, {9, 0, 3}, {0, 0, -3});
  CHECK(h.list() == "[0/1 1/1] 0");
  CHECK(h.boundary() == Ids{0});
}

TEST_CASE("a touch at one moment is no sight") {
  HandMade h;
  h.wall(-4).add({0, 0, -2}, {1, 1, -2}, {-1, 1, -2});
  CHECK(h.list() == "[0/1 1/1] 0");
}

TEST_CASE("a segment of length zero answers the point query at the centres") {
  HandMade h;
  h.wall(-4).wall(-5).along({0, 0, 0}, {0, 0, 0});
  CHECK(h.list() == "[0/1 1/1] 0");
  CHECK(h.boundary() == Ids{});
}

TEST_CASE("pixels are counted and lengths measured") {
  HandMade h;
  h.wall(-4).add({-0.25, -1, -2}, {0.25, -1, -2}, {0, 1, -2});
  h.view.pixels = {3, 1};
  h.view.frames.front().window = {-0.001, 0.001, -0.001, 0.001};
  const SegmentSet set = visible_from_segment(Scene(h.arrays), h.view);
  REQUIRE(set.seen.size() == 2);
  CHECK(set.seen[0].pixels == 3);
  CHECK(set.seen[1].pixels == 3);
  CHECK(set.seen[1].length == Approx(3 * 0.125).epsilon(1e-9));
  CHECK(set.seen[0].length == Approx(3 * 0.875).epsilon(1e-9));
}

TEST_CASE("a row that is asked for alone is that row of the whole answer") {
  HandMade h;
  h.wall(-4).add({-0.25, -1, -2}, {0.25, -1, -2}, {0, 1, -2}).add({-0.5, -9, -3}, {9, -9, -3}, {0, 9, -3});
  h.view.pixels = {21, 37};
  h.view.frames = omni({0, 0, 0}).frames;
  const std::vector<std::string> all = answer(Scene(h.arrays), h.view).sights;
  for (const SegmentEngine engine : {SegmentEngine::fast, SegmentEngine::plain})
    for (const PixelRow only : {PixelRow{0, 0}, PixelRow{5, 18}, PixelRow{5, 36}}) {
      SegmentOptions options;
      options.engine = engine;
      options.only = only;
      const auto first = all.begin() + (only.frame * 37 + only.row) * 21;
      CHECK(answer(Scene(h.arrays), h.view, options).sights == std::vector<std::string>(first, first + 21));
    }
}

TEST_CASE("what makes no sense, or is not handled, is refused and named") {
  const auto code = [](const HandMade& h, const SegmentOptions& options = {}) {
    try {
      visible_from_segment(Scene(h.arrays), h.view, options);
    } catch (const Error& e) {
      return e.code();
    }
    return Error::Code::internal;
  };
  HandMade h;
  h.view.pixels = {0, 1};
  CHECK(code(h) == Error::Code::usage);
  h.view.pixels = {1, 16385};
  CHECK(code(h) == Error::Code::usage);
  h.view.pixels = {1, 1};
  h.view.frames.clear();
  CHECK(code(h) == Error::Code::usage);
  h.view.frames = {Frame{{1, 0, 0}, {2, 0, 0}, {0, 0, -1}, {}}};
  CHECK(code(h) == Error::Code::usage);
  h.view.frames = {Frame{}};
  h.view.to.x = HUGE_VAL;
  CHECK(code(h) == Error::Code::usage);
  h.view.to.x = 1;
  SegmentOptions doubles;
  doubles.arithmetic = Arithmetic::doubles;
  doubles.witnesses = true;
  CHECK(code(h, doubles) == Error::Code::usage);
  for (const PixelRow only : {PixelRow{1, 0}, PixelRow{-1, 0}, PixelRow{0, 1}, PixelRow{0, -1}}) {
    SegmentOptions row;
    row.only = only;
    CHECK(code(h, row) == Error::Code::usage);
  }
  h.arrays.spheres = {{{0, 0, -3}, 1}};
  h.arrays.sphere_flags = {0};
  CHECK(code(h) == Error::Code::unsupported);
}

}  // namespace provis::test
