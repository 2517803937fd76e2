#pragma once
// The node hierarchy, and which of it a scene shows.

#include <optional>
#include <vector>

#include "src/scene/gltf_model.hpp"

namespace provis {

/// Every node's parent, -1 for roots.
///
/// Guarantee:  following parents always ends at a root
/// Throws:     Error::invalid_input naming the node: index out of range, several parents, a cycle
std::vector<int> node_parents(const tinygltf::Model& model);

/// The scene that is asked for, else the default one, else 0; -1 in a file without scenes.
///
/// Throws:     Error::usage if the one asked for does not exist, Error::invalid_input if the default one does
/// not
int chosen_scene(const tinygltf::Model& model, std::optional<int> asked);

/// The nodes of that scene that have a mesh, depth-first in file order; for -1 of all roots there are.
///
/// Throws:     Error::invalid_input naming the scene: a root that is a child, does not exist or is listed
/// twice
std::vector<int> mesh_nodes(const tinygltf::Model& model, const std::vector<int>& parents, int scene);

}  // namespace provis
