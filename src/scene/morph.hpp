#pragma once
// Morph targets: weighted displacements of a primitive's positions.

#include <optional>
#include <string>
#include <vector>

#include "src/scene/accessor.hpp"

namespace provis {

/// positions + weight * displacement for one target after the other, or nothing where that changes nothing.
///
/// weights:    of all targets; empty if nobody gives any, which stands for zeros
/// Degenerate: targets of weight 0 are never read, targets without POSITION displace nothing
/// Throws:     Error::invalid_input at place or naming the accessor: weights or displacements of a wrong
///             number
std::optional<std::vector<Vec3d>> morphed(const std::vector<Vec3d>& positions,
                                          const tinygltf::Primitive& primitive,
                                          const std::vector<double>& weights, AccessorReader& accessors,
                                          const std::string& place);

}  // namespace provis
