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

std::vector<int> all_roots(const std::vector<int>& parents) {
  std::vector<int> roots;
  for (std::size_t n = 0; n < parents.size(); ++n)
    if (parents[n] == no_parent) roots.push_back(static_cast<int>(n));
  return roots;
}

/// Every node has at most one parent, so whatever no root leads to runs in a circle.
void check_no_cycle(const tinygltf::Model& model, const std::vector<int>& parents) {
  std::vector<bool> reached(parents.size(), false);
  std::vector<int> open = all_roots(parents);
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

std::vector<int> roots_of(const tinygltf::Model& model, const std::vector<int>& parents, int scene) {
  if (scene < 0) return all_roots(parents);
  const std::vector<int>& roots = model.scenes[static_cast<std::size_t>(scene)].nodes;
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

}  // namespace

std::vector<int> node_parents(const tinygltf::Model& model) {
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
  check_no_cycle(model, parents);
  return parents;
}

int chosen_scene(const tinygltf::Model& model, std::optional<int> asked) {
  const std::size_t count = model.scenes.size();
  if (asked) {
    if (*asked < 0 || static_cast<std::size_t>(*asked) >= count)
      throw Error(Error::Code::usage, "--scene", fmt::format("scene {} of {} does not exist", *asked, count));
    return *asked;
  }
  if (count == 0 && model.defaultScene < 0) return -1;
  const int scene = std::max(model.defaultScene, 0);
  if (static_cast<std::size_t>(scene) >= count)
    fail_invalid("scene", fmt::format("scene {} of {} does not exist", scene, count));
  return scene;
}

std::vector<int> mesh_nodes(const tinygltf::Model& model, const std::vector<int>& parents, int scene) {
  const std::vector<int> roots = roots_of(model, parents, scene);
  // A stack of our own, since a file may nest deeper than the program's stack reaches.
  std::vector<int> open(roots.rbegin(), roots.rend()), found;
  while (!open.empty()) {
    const int next = open.back();
    open.pop_back();
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(next)];
    open.insert(open.end(), node.children.rbegin(), node.children.rend());
    if (node.mesh >= 0) found.push_back(next);
  }
  return found;
}

}  // namespace provis
