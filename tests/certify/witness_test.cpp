// A witness that does not hold is refused, with the reason.

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "provis/error.hpp"
#include "provis/point.hpp"
#include "provis/witness.hpp"
#include "src/certify/exact_ray.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/random.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

/// A wall at z = -2 behind a smaller one at z = -1, both facing the eye at the origin.
SceneArrays two_walls() {
  SceneArrays a;
  a.vertices = {{-8, -8, -2}, {8, -8, -2}, {0, 8, -2}, {-1, -1, -1}, {1, -1, -1}, {0, 1, -1}};
  a.triangles = {{0, 1, 2}, {3, 4, 5}};
  a.triangle_flags = {0, 0};
  return a;
}

const PointView straight_ahead{{0, 0, 0}, Projection::pinhole, {Frame{}}};

Witness ray(PrimitiveId primitive, long x, long y, long z, long exponent = 0) {
  const auto number = [&](long mantissa) { return Dyadic{std::to_string(mantissa), exponent}; };
  return {primitive, {}, {number(x), number(y), number(z)}};
}

/// The reason why a single witness is refused, or nothing.
std::string refusal(const SceneArrays& arrays, const PointView& view, const Witness& witness) {
  VisibleSet set;
  set.status.assign(arrays.triangles.size(), Status::hidden);
  if (witness.primitive < set.status.size()) set.status[witness.primitive] = Status::visible;
  set.witnesses = {witness};
  try {
    const std::size_t checked = verify_witnesses(Scene(arrays), view, set);
    CHECK(checked == 1);
  } catch (const Error& e) {
    CHECK(e.code() == Error::Code::rejected);
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("rays that prove what they claim pass") {
  CHECK(refusal(two_walls(), straight_ahead, ray(1, 0, 0, -1)) == "");
  CHECK(refusal(two_walls(), straight_ahead, ray(1, 0, 0, -3, -70)) == "");
  CHECK(refusal(two_walls(), straight_ahead, ray(0, 7, 0, -8, -3)) == "");
}

TEST_CASE("rays that do not are refused with the reason") {
  const SceneArrays walls = two_walls();
  CHECK_THAT(refusal(walls, straight_ahead, ray(0, 0, 0, -1)), Catch::Contains("triangle 1 is in the way"));
  CHECK_THAT(refusal(walls, straight_ahead, ray(1, 7, 0, -8)), Catch::Contains("relative interior"));
  CHECK_THAT(refusal(walls, straight_ahead, ray(1, 0, -1, -1)), Catch::Contains("relative interior"));
  CHECK_THAT(refusal(walls, straight_ahead, ray(0, 2, 0, -1)),
             Catch::Contains("does not belong to the view"));
  CHECK_THAT(refusal(walls, straight_ahead, ray(1, 0, 0, 1)), Catch::Contains("does not belong to the view"));
  CHECK_THAT(refusal(walls, straight_ahead, ray(0, 0, 0, 0)), Catch::Contains("zero"));
  CHECK_THAT(refusal(walls, straight_ahead, ray(7, 0, 0, -1)), Catch::Contains("not a triangle"));
  Witness elsewhere = ray(1, 0, 0, -1);
  elsewhere.origin.x = {"1", -60};
  CHECK_THAT(refusal(walls, straight_ahead, elsewhere), Catch::Contains("does not belong to the view"));
  Witness garbled = ray(1, 0, 0, -1);
  garbled.direction.y.mantissa = "1.5";
  CHECK_THAT(refusal(walls, straight_ahead, garbled), Catch::Contains("not a number"));
}

TEST_CASE("an occluder that only touches the ray is in the way, a coplanar or see-through one is not") {
  SceneArrays walls = two_walls();
  // The edge of the near wall, seen in front of the far one.
  const Witness past_the_edge = ray(0, 0, -1, -1);
  CHECK_THAT(refusal(walls, straight_ahead, past_the_edge), Catch::Contains("in the way"));
  walls.triangle_flags[1] = see_through;
  CHECK(refusal(walls, straight_ahead, past_the_edge) == "");
  walls = two_walls();
  for (std::size_t v = 3; v < 6; ++v) walls.vertices[v].z = -2;
  CHECK(refusal(walls, straight_ahead, ray(0, 0, 0, -1)) == "");
}

TEST_CASE("a side that is not there is no hit") {
  SceneArrays walls = two_walls();
  std::swap(walls.triangles[1][1], walls.triangles[1][2]);
  CHECK(refusal(walls, straight_ahead, ray(1, 0, 0, -1)) == "");
  walls.triangle_flags[1] = single_sided;
  CHECK_THAT(refusal(walls, straight_ahead, ray(1, 0, 0, -1)), Catch::Contains("side"));
  CHECK(refusal(walls, straight_ahead, ray(0, 0, 0, -1)) == "");
}

TEST_CASE("a visible primitive without a witness is refused") {
  VisibleSet set;
  set.status = {Status::visible, Status::hidden};
  CHECK_THROWS_WITH(verify_witnesses(Scene(two_walls()), straight_ahead, set),
                    Catch::Contains("primitive 0") && Catch::Contains("without a witness"));
}

TEST_CASE("both checkers refuse the same bent witnesses") {
  PointOptions options;
  options.witnesses = true;
  std::size_t refused = 0;
  for (const std::uint64_t seed : seeds(6)) {
    const Case c = generate(seed);
    INFO(describe(c));
    const Scene scene(c.arrays);
    const RayChecker other(scene, c.view);
    Random random(seed);
    for (Witness w : visible_from_point(scene, c.view, options).witnesses) {
      // Another primitive's claim on the same ray, and a direction a little off.
      if (random.chance(50)) w.primitive = random.below(scene.primitive_count());
      if (random.chance(50)) w.direction.x = {std::to_string(random.between(-9, 9)), random.between(-4, 2)};
      const std::string reason = refusal(c.arrays, c.view, w);
      INFO(reason);
      REQUIRE((reason == "") == (other.refuse(w) == ""));
      refused += reason != "";
    }
  }
  CHECK(refused > 0);
}

TEST_CASE("numbers among the subnormals keep their bounds") {
  const RoundUp guard;
  const Witness w{0, {}, {{"3", -1074}, {"-1", -1100}, {"1", 0}}};
  const ExactRay tiny(w);
  // The tip of the ray at distance 1: a box that holds it must be met, one beside it must not.
  const double d = 5e-324;
  CHECK(tiny.may_meet({{3 * d, -d, 1}, {3 * d, 0, 1}}));
  CHECK_FALSE(tiny.may_meet({{4 * d, -d, 1}, {5 * d, 0, 1}}));
}

}  // namespace provis::test
