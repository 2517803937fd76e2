#pragma once
// Which effects a query has to simulate on a given scene, and why: everything else is left out.

#include <string>
#include <string_view>
#include <vector>

#include "provis/scene.hpp"
#include "provis/view.hpp"

namespace provis {

enum class Effect {
  single_sided,  ///< culling by facing (R4)
  see_through,   ///< surfaces that are seen and do not occlude (R5)
  spheres,       ///< quadrics beside planes
  front_clip,    ///< a cut at distance 0, needed only for an eye at infinity (R8)
};

struct EffectNeed {
  Effect effect;
  bool needed = false;
  std::string reason;  ///< one clause: "3 of 56100 triangles let light through"
};

/// One entry per effect, in the order of the enumeration.
struct EffectsPlan {
  std::vector<EffectNeed> needs;

  bool needs_effect(Effect effect) const;
};

std::string_view name(Effect effect);

/// What the scene and the projection call for.
///
/// Guarantee:  an effect that is left out could not change the answer
/// Degenerate: an empty scene needs nothing
/// Cost:       O(F), no arithmetic
EffectsPlan plan_effects(const Scene& scene, Projection projection);

}  // namespace provis
