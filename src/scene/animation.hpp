#pragma once
// An animation at a time: what it makes of the nodes it drives.

#include "src/scene/accessor.hpp"
#include "src/scene/asked_animation.hpp"
#include "src/scene/pose.hpp"

namespace provis {

/// Every channel's value at that time.
///
/// Throws:     Error::invalid_input naming channel, sampler or accessor: a node that does not exist or has a
///             matrix, weights of a node without morph targets, keys that do not grow, a wrong number of
///             values, a value that is not finite
AnimatedNodes animated_nodes(const AskedAnimation& animation, double time, const tinygltf::Model& model,
                             AccessorReader& accessors);

}  // namespace provis
