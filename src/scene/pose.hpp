#pragma once
// The pose of a document's nodes: local properties, as stored or as animated, and global maps.

#include <optional>
#include <unordered_map>
#include <vector>

#include "src/scene/gltf_model.hpp"
#include "src/scene/placement.hpp"

namespace provis {

/// What an animation sets at one node; the rest stays as the file has it.
struct AnimatedNode {
  std::optional<std::vector<double>> translation, rotation, scale, weights;
};

/// By node index.
using AnimatedNodes = std::unordered_map<int, AnimatedNode>;

/// Maps are computed when first asked for, so that nodes that place nothing may be broken.
class Pose {
 public:
  /// parents: of every node, -1 for roots, without cycles; all must outlive the pose
  Pose(const tinygltf::Model& model, const std::vector<int>& parents, AnimatedNodes animated);

  /// The global map, through all ancestors up to a root, whatever scene they belong to.
  ///
  /// Throws:     Error::invalid_input naming the node where the map overflows
  const Placement& world(int node);

  /// Of morph targets: the animation's, else the node's, else the mesh's; empty if nobody gives any.
  const std::vector<double>& weights(int node) const;

 private:
  Placement local(int node) const;

  const tinygltf::Model& model_;
  const std::vector<int>& parents_;
  AnimatedNodes animated_;
  std::vector<std::optional<Placement>> worlds_;
};

}  // namespace provis
