#include "provis/effects.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace provis {
namespace {

std::size_t count_flag(const Scene& scene, PrimitiveFlag flag) {
  const auto has = [flag](std::uint8_t flags) { return (flags & flag) != 0; };
  return static_cast<std::size_t>(std::ranges::count_if(scene.triangle_flags(), has) +
                                  std::ranges::count_if(scene.sphere_flags(), has));
}

/// "none of 36 triangles", "3 of 56100 triangles".
std::string share(const Scene& scene, std::size_t count) {
  const char* what = scene.spheres().empty() ? "triangles" : "primitives";
  if (count == 0) return fmt::format("none of {} {}", scene.primitive_count(), what);
  return fmt::format("{} of {} {}", count, scene.primitive_count(), what);
}

EffectNeed flag_need(const Scene& scene, Effect effect, PrimitiveFlag flag, const char* verb) {
  const std::size_t count = count_flag(scene, flag);
  return {effect, count > 0, fmt::format("{} {}", share(scene, count), verb)};
}

EffectNeed sphere_need(const Scene& scene) {
  const std::size_t count = scene.spheres().size();
  return {Effect::spheres, count > 0, count > 0 ? fmt::format("{} spheres", count) : "no spheres"};
}

EffectNeed front_clip_need(Projection projection) {
  if (projection == Projection::parallel)
    return {Effect::front_clip, true, "the eye is at infinity: primitives may lie behind the window"};
  return {Effect::front_clip, false, "a finite eye sees nothing at negative distances"};
}

}  // namespace

bool EffectsPlan::needs_effect(Effect effect) const {
  return std::ranges::any_of(needs, [effect](const EffectNeed& n) { return n.effect == effect && n.needed; });
}

std::string_view name(Effect effect) {
  switch (effect) {
    case Effect::single_sided:
      return "single-sided";
    case Effect::see_through:
      return "see-through";
    case Effect::spheres:
      return "spheres";
    case Effect::front_clip:
      return "front-clip";
  }
  return "";
}

EffectsPlan plan_effects(const Scene& scene, Projection projection) {
  EffectsPlan plan{{flag_need(scene, Effect::single_sided, single_sided, "show one side only"),
                    flag_need(scene, Effect::see_through, see_through, "let light through"),
                    sphere_need(scene), front_clip_need(projection)}};
  if (scene.primitive_count() == 0)
    for (EffectNeed& need : plan.needs) need = {need.effect, false, "the scene is empty"};
  return plan;
}

}  // namespace provis
