#pragma once
// The node hierarchy of a scene, flattened.

#include <vector>

#include "src/scene/gltf_model.hpp"
#include "src/scene/placement.hpp"

namespace provis {

struct PlacedNode {
  int node = -1;
  Placement world;
};

/// The nodes of the default scene that have a mesh, depth-first in file order, with their global maps.
/// Without a default scene it is scene 0; without any scene every node that is no child.
///
/// Throws:     Error::invalid_input naming the node: index out of range, several parents, a cycle, a
///             root that is a child, a matrix that is no affine map or overflows
std::vector<PlacedNode> placed_meshes(const tinygltf::Model& model);

}  // namespace provis
