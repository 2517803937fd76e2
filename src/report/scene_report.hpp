#pragma once
// What `info` says about a scene, for people and for programs.

#include <string>

#include "provis/effects.hpp"
#include "provis/scene.hpp"

namespace provis {

/// The plan as lines "effect  needed|left out  reason".
std::string effects_text(const EffectsPlan& plan);

/// Counts, extent, flags, what was skipped, the hash and the effects plan.
std::string scene_text(const std::string& file, const Scene& scene, const EffectsPlan& plan);

/// The same as JSON of format "provis.scene-info", version 1.
std::string scene_json(const std::string& file, const Scene& scene, const EffectsPlan& plan);

}  // namespace provis
