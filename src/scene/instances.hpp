#pragma once
// EXT_mesh_gpu_instancing: many copies of a node's mesh.

#include <string>
#include <vector>

#include "src/scene/accessor.hpp"
#include "src/scene/placement.hpp"

namespace provis {

/// Whether the node is drawn once per instance instead of once.
bool is_instanced(const tinygltf::Node& node);

/// Each instance's own map, below the node's global one, in the order of the accessors.
///
/// Requires:   is_instanced(node)
/// Degenerate: without TRANSLATION, ROTATION or SCALE those are nothing, identity and 1
/// Throws:     Error::invalid_input at place or naming the accessor: different counts, or an accessor of
///             another type than the extension allows
std::vector<Placement> instance_maps(const tinygltf::Node& node, AccessorReader& accessors,
                                     const std::string& place);

}  // namespace provis
