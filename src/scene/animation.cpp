#include "src/scene/animation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

constexpr unsigned float_or_normalized = float_components | normalized_signed | normalized_unsigned;

ElementKind output_kind(NodeProperty property) {
  switch (property) {
    case NodeProperty::rotation:
      return {"rotations", TINYGLTF_TYPE_VEC4, float_or_normalized};
    case NodeProperty::weights:
      return {"weights", TINYGLTF_TYPE_SCALAR, float_or_normalized};
    case NodeProperty::scale:
      return {"scales", TINYGLTF_TYPE_VEC3, float_components};
    case NodeProperty::translation:
      break;
  }
  return {"translations", TINYGLTF_TYPE_VEC3, float_components};
}

const tinygltf::Node& driven_node(const AnimationChannel& channel, const tinygltf::Model& model) {
  const auto node = static_cast<std::size_t>(channel.node);
  if (node >= model.nodes.size())
    fail_invalid(channel.place, fmt::format("node {} of {} does not exist", node, model.nodes.size()));
  if (!model.nodes[node].matrix.empty())
    fail_invalid(fmt::format("nodes[{}]", node), "has a matrix, but is animated");
  return model.nodes[node];
}

/// How many morph targets the node's mesh has.
std::size_t target_count(const AnimationChannel& channel, const tinygltf::Model& model) {
  const auto mesh = static_cast<std::size_t>(driven_node(channel, model).mesh);
  const bool morphs = mesh < model.meshes.size() && !model.meshes[mesh].primitives.empty() &&
                      !model.meshes[mesh].primitives[0].targets.empty();
  if (!morphs) fail_invalid(channel.place, fmt::format("node {} has no morph targets", channel.node));
  return model.meshes[mesh].primitives[0].targets.size();
}

std::vector<double> key_times(const AnimationChannel& channel, AccessorReader& accessors) {
  constexpr ElementKind kind = {"key times", TINYGLTF_TYPE_SCALAR, float_components};
  std::vector<double> times = accessors.numbers(channel.input, kind, channel.sampler_place + ".input");
  const std::string place = fmt::format("accessors[{}]", channel.input);
  if (times.empty()) fail_invalid(place, "no key times");
  const auto late = std::ranges::adjacent_find(times, std::greater_equal<>());
  if (late != times.end())
    fail_invalid(place, fmt::format("element {}, a key time of {}, does not exceed the one before it",
                                    late - times.begin() + 1, *(late + 1)));
  return times;
}

std::size_t component_count(const AnimationChannel& channel, const tinygltf::Model& model) {
  switch (channel.property) {
    case NodeProperty::rotation:
      return 4;
    case NodeProperty::weights:
      return target_count(channel, model);
    default:
      return 3;
  }
}

KeyFrames key_frames(const AnimationChannel& channel, const tinygltf::Model& model,
                     AccessorReader& accessors) {
  KeyFrames keys;
  keys.interpolation = channel.interpolation;
  keys.components = component_count(channel, model);
  if (channel.property == NodeProperty::rotation) keys.quantity = Quantity::rotation;
  keys.times = key_times(channel, accessors);
  keys.values =
      accessors.numbers(channel.output, output_kind(channel.property), channel.sampler_place + ".output");
  const std::size_t parts = keys.interpolation == Interpolation::cubic_spline ? 3 : 1;
  const std::size_t expected = keys.times.size() * parts * keys.components;
  if (keys.values.size() != expected)
    fail_invalid(channel.sampler_place, fmt::format("{} numbers for {} keys instead of {}",
                                                    keys.values.size(), keys.times.size(), expected));
  return keys;
}

std::optional<std::vector<double>>& property_of(AnimatedNode& node, NodeProperty property) {
  switch (property) {
    case NodeProperty::rotation:
      return node.rotation;
    case NodeProperty::scale:
      return node.scale;
    case NodeProperty::weights:
      return node.weights;
    case NodeProperty::translation:
      break;
  }
  return node.translation;
}

}  // namespace

AnimatedNodes animated_nodes(const AskedAnimation& animation, double time, const tinygltf::Model& model,
                             AccessorReader& accessors) {
  AnimatedNodes nodes;
  for (const AnimationChannel& channel : animation.channels) {
    driven_node(channel, model);
    std::vector<double> value = value_at(key_frames(channel, model, accessors), time);
    if (!std::ranges::all_of(value, [](double x) { return std::isfinite(x); }))
      fail_invalid(channel.sampler_place, fmt::format("the value at {} s is not finite", time));
    property_of(nodes[channel.node], channel.property) = std::move(value);
  }
  return nodes;
}

}  // namespace provis
