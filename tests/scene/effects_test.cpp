// The plan of effects: which, and why.
#include "provis/effects.hpp"

#include <catch2/catch.hpp>

#include "tests/scene/fixed_scene.hpp"

namespace provis {
namespace {

Scene with_flags(std::vector<std::uint8_t> flags, std::size_t spheres = 0) {
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  arrays.triangles.resize(flags.size(), {0, 1, 2});
  arrays.triangle_flags = std::move(flags);
  arrays.spheres.resize(spheres, {{5, 5, 5}, 1});
  arrays.sphere_flags.resize(spheres, 0);
  return Scene(arrays);
}

std::string reason(const EffectsPlan& plan, Effect effect) {
  return plan.needs.at(static_cast<std::size_t>(effect)).reason;
}

TEST_CASE("a plain scene needs nothing") {
  const EffectsPlan plan = plan_effects(with_flags({0, 0}), Projection::pinhole);
  REQUIRE(plan.needs.size() == 4);
  for (const EffectNeed& need : plan.needs) CHECK_FALSE(need.needed);
  CHECK(reason(plan, Effect::single_sided) == "none of 2 triangles show one side only");
  CHECK(reason(plan, Effect::see_through) == "none of 2 triangles let light through");
  CHECK(reason(plan, Effect::spheres) == "no spheres");
}

TEST_CASE("each effect is called for by what the scene holds") {
  const auto needs = [](const Scene& scene, Effect effect) {
    return plan_effects(scene, Projection::omni).needs_effect(effect);
  };
  CHECK(needs(with_flags({0, single_sided}), Effect::single_sided));
  CHECK_FALSE(needs(with_flags({0, single_sided}), Effect::see_through));
  CHECK(needs(with_flags({see_through}), Effect::see_through));
  CHECK_FALSE(needs(with_flags({see_through}), Effect::single_sided));
  CHECK(needs(with_flags({}, 1), Effect::spheres));
  CHECK_FALSE(needs(with_flags({0}), Effect::spheres));
}

TEST_CASE("reasons count") {
  const EffectsPlan plan = plan_effects(Scene(fixed_arrays()), Projection::pinhole);
  CHECK(reason(plan, Effect::single_sided) == "3 of 5 primitives show one side only");
  CHECK(reason(plan, Effect::see_through) == "2 of 5 primitives let light through");
  CHECK(reason(plan, Effect::spheres) == "2 spheres");
  CHECK(reason(plan_effects(with_flags({2, 0, 0}), Projection::omni), Effect::see_through) ==
        "1 of 3 triangles let light through");
}

TEST_CASE("only an eye at infinity needs the cut at its window") {
  CHECK(plan_effects(with_flags({0}), Projection::parallel).needs_effect(Effect::front_clip));
  CHECK_FALSE(plan_effects(with_flags({0}), Projection::pinhole).needs_effect(Effect::front_clip));
  CHECK_FALSE(plan_effects(with_flags({0}), Projection::omni).needs_effect(Effect::front_clip));
}

TEST_CASE("an empty scene needs nothing, for a reason") {
  const EffectsPlan plan = plan_effects(Scene(), Projection::parallel);
  REQUIRE(plan.needs.size() == 4);
  for (const EffectNeed& need : plan.needs) {
    CHECK_FALSE(need.needed);
    CHECK(need.reason == "the scene is empty");
  }
}

TEST_CASE("entries come in the order of the enumeration, with names") {
  const EffectsPlan plan = plan_effects(with_flags({0}), Projection::pinhole);
  const char* names[] = {"single-sided", "see-through", "spheres", "front-clip"};
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(static_cast<std::size_t>(plan.needs[i].effect) == i);
    CHECK(name(plan.needs[i].effect) == names[i]);
  }
}

}  // namespace
}  // namespace provis
