#include "src/scene/pose.hpp"

#include <fmt/format.h>

#include <utility>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

std::string place_of(int node) { return fmt::format("nodes[{}]", node); }

}  // namespace

Pose::Pose(const tinygltf::Model& model, const std::vector<int>& parents, AnimatedNodes animated)
    : model_(model), parents_(parents), animated_(std::move(animated)), worlds_(model.nodes.size()) {}

const Placement& Pose::world(int node) {
  // A list of our own instead of recursion, since a file may nest deeper than the program's stack reaches.
  std::vector<int> open;
  int above = node;
  while (above >= 0 && !worlds_[static_cast<std::size_t>(above)]) {
    open.push_back(above);
    above = parents_[static_cast<std::size_t>(above)];
  }
  Placement map = above < 0 ? Placement{} : *worlds_[static_cast<std::size_t>(above)];
  for (auto next = open.rbegin(); next != open.rend(); ++next) {
    map = compose(map, local(*next));
    if (!map.finite()) fail_invalid(place_of(*next), "the global matrix overflows");
    worlds_[static_cast<std::size_t>(*next)] = map;
  }
  return *worlds_[static_cast<std::size_t>(node)];
}

const std::vector<double>& Pose::weights(int node) const {
  const auto found = animated_.find(node);
  if (found != animated_.end() && found->second.weights) return *found->second.weights;
  const tinygltf::Node& n = model_.nodes[static_cast<std::size_t>(node)];
  return n.weights.empty() ? model_.meshes[static_cast<std::size_t>(n.mesh)].weights : n.weights;
}

Placement Pose::local(int node) const {
  const tinygltf::Node& n = model_.nodes[static_cast<std::size_t>(node)];
  if (!n.matrix.empty()) return from_columns(n.matrix);
  const auto found = animated_.find(node);
  if (found == animated_.end()) return from_trs(n.translation, n.rotation, n.scale);
  const AnimatedNode& a = found->second;
  return from_trs(a.translation.value_or(n.translation), a.rotation.value_or(n.rotation),
                  a.scale.value_or(n.scale));
}

}  // namespace provis
