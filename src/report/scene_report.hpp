#pragma once
// What `info` says about a scene, for people and for programs.

#include <iosfwd>
#include <map>
#include <string>

#include "provis/effects.hpp"
#include "provis/scene.hpp"
#include "provis/topology.hpp"

namespace provis {

/// What it took to load a scene: differs between runs and machines.
struct LoadCost {
  double seconds = 0;
  std::size_t peak_resident_bytes = 0;  ///< of the whole program, once the scene was loaded
};

/// What was found out about a scene, besides what it says itself.
struct SceneInfo {
  std::string file;
  std::map<std::string, std::string> options;  ///< as a result records them
  SceneSummary counts;
  Topology topology;
  EffectsPlan effects;
  LoadCost cost;
};

/// The plan as lines "effect  needed|left out  reason".
std::string effects_text(const EffectsPlan& plan);

/// Some twenty lines, each ended.
std::string scene_text(const Scene& scene, const SceneInfo& info);

/// JSON of format "provis.scene-info", version 1 (README.md), as a stream: the table of sources can be long.
void write_scene_json(const Scene& scene, const SceneInfo& info, std::ostream& out);

}  // namespace provis
