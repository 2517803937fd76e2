#include "src/scene/gltf_nodes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

constexpr int no_parent = -1;

std::string place_of(int node) { return fmt::format("nodes[{}]", node); }

void check_node_index(int node, std::size_t count, const std::string& place) {
  if (static_cast<std::size_t>(node) >= count)
    fail_invalid(place, fmt::format("node {} of {} does not exist", node, count));
}

std::vector<int> parents_of(const tinygltf::Model& model) {
  std::vector<int> parents(model.nodes.size(), no_parent);
  for (std::size_t n = 0; n < model.nodes.size(); ++n) {
    const int node = static_cast<int>(n);
    for (const int child : model.nodes[n].children) {
      check_node_index(child, parents.size(), place_of(node) + ".children");
      int& parent = parents[static_cast<std::size_t>(child)];
      if (parent != no_parent)
        fail_invalid(place_of(child), fmt::format("is a child of both node {} and node {}", parent, node));
      parent = node;
    }
  }
  return parents;
}

/// Every node has at most one parent, so whatever no root leads to runs in a circle.
void check_no_cycle(const tinygltf::Model& model, const std::vector<int>& parents) {
  std::vector<bool> reached(parents.size(), false);
  std::vector<int> open;
  for (std::size_t n = 0; n < parents.size(); ++n)
    if (parents[n] == no_parent) open.push_back(static_cast<int>(n));
  while (!open.empty()) {
    const auto node = static_cast<std::size_t>(open.back());
    open.pop_back();
    reached[node] = true;
    open.insert(open.end(), model.nodes[node].children.begin(), model.nodes[node].children.end());
  }
  const auto lost = std::ranges::find(reached, false);
  if (lost != reached.end())
    fail_invalid(place_of(static_cast<int>(lost - reached.begin())),
                 "is its own ancestor, or below a node that is");
}

std::vector<int> roots_of(const tinygltf::Model& model, const std::vector<int>& parents) {
  if (model.scenes.empty() && model.defaultScene < 0) {
    std::vector<int> roots;
    for (std::size_t n = 0; n < parents.size(); ++n)
      if (parents[n] == no_parent) roots.push_back(static_cast<int>(n));
    return roots;
  }
  const auto scene = static_cast<std::size_t>(std::max(model.defaultScene, 0));
  if (scene >= model.scenes.size())
    fail_invalid("scene", fmt::format("scene {} of {} does not exist", scene, model.scenes.size()));
  const std::vector<int>& roots = model.scenes[scene].nodes;
  const std::string place = fmt::format("scenes[{}].nodes", scene);
  std::vector<bool> listed(parents.size(), false);
  for (const int root : roots) {
    check_node_index(root, parents.size(), place);
    const auto r = static_cast<std::size_t>(root);
    if (parents[r] != no_parent)
      fail_invalid(place, fmt::format("node {} is no root, but a child of node {}", root, parents[r]));
    if (listed[r]) fail_invalid(place, fmt::format("node {} is listed twice", root));
    listed[r] = true;
  }
  return roots;
}

Placement local_placement(const tinygltf::Node& node, int index) {
  if (node.matrix.empty()) return from_trs(node.translation, node.rotation, node.scale);
  const std::vector<double>& m = node.matrix;
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    fail_invalid(place_of(index) + ".matrix",
                 fmt::format("the last row is ({}, {}, {}, {})", m[3], m[7], m[11], m[15]));
  return from_columns(m);
}

}  // namespace

std::vector<PlacedNode> placed_meshes(const tinygltf::Model& model) {
  const std::vector<int> parents = parents_of(model);
  check_no_cycle(model, parents);
  const std::vector<int> roots = roots_of(model, parents);

  // A stack of our own, since a file may nest deeper than the program's stack reaches.
  std::vector<PlacedNode> open, placed;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) open.push_back({*root, Placement{}});
  while (!open.empty()) {
    PlacedNode next = std::move(open.back());
    open.pop_back();
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(next.node)];
    next.world = compose(next.world, local_placement(node, next.node));
    if (!next.world.finite()) fail_invalid(place_of(next.node), "the global matrix overflows");
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      open.push_back({*child, next.world});
    if (node.mesh >= 0) placed.push_back(next);
  }
  return placed;
}

}  // namespace provis
