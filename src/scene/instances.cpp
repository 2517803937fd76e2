#include "src/scene/instances.hpp"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/gltf_reduce.hpp"

namespace provis {
namespace {

using Attributes = std::map<std::string, int>;

/// Every attribute counts, those of applications too: the extension gives no other number of instances.
Attributes attributes_of(const tinygltf::Node& node) {
  Attributes attributes;
  const tinygltf::Value& all = node.extensions.at(instancing_extension).Get("attributes");
  for (const std::string& name : all.Keys()) attributes[name] = all.Get(name).GetNumberAsInt();
  return attributes;
}

std::size_t common_count(const Attributes& attributes, AccessorReader& accessors, const std::string& place) {
  std::optional<std::size_t> common;
  for (const auto& [name, accessor] : attributes) {
    const std::size_t count = accessors.count(accessor, fmt::format("{}.attributes.{}", place, name));
    if (common && *common != count)
      fail_invalid(place, fmt::format("accessors[{}]: {} elements, but other attributes have {}", accessor,
                                      count, *common));
    common = count;
  }
  return common.value_or(0);
}

/// The values of one attribute, an element at a time; empty ones where the file has none.
class Column {
 public:
  Column(const Attributes& attributes, const char* name, const ElementKind& kind, AccessorReader& accessors,
         const std::string& place)
      : components_(kind.type == TINYGLTF_TYPE_VEC4 ? 4 : 3) {
    const auto found = attributes.find(name);
    if (found != attributes.end())
      values_ = accessors.numbers(found->second, kind, fmt::format("{}.attributes.{}", place, name));
  }

  std::vector<double> at(std::size_t element) const {
    if (values_.empty()) return {};
    const auto first = values_.begin() + static_cast<std::ptrdiff_t>(element * components_);
    return {first, first + static_cast<std::ptrdiff_t>(components_)};
  }

 private:
  std::size_t components_;
  std::vector<double> values_;
};

}  // namespace

bool is_instanced(const tinygltf::Node& node) { return node.extensions.count(instancing_extension) != 0; }

std::vector<Placement> instance_maps(const tinygltf::Node& node, AccessorReader& accessors,
                                     const std::string& node_place) {
  constexpr ElementKind vectors = {"translations or scales", TINYGLTF_TYPE_VEC3, float_components};
  constexpr ElementKind quaternions = {"rotations", TINYGLTF_TYPE_VEC4, float_components | normalized_signed};
  const std::string place = fmt::format("{}.extensions.{}", node_place, instancing_extension);
  const Attributes attributes = attributes_of(node);
  const std::size_t count = common_count(attributes, accessors, place);
  const Column translation(attributes, "TRANSLATION", vectors, accessors, place),
      rotation(attributes, "ROTATION", quaternions, accessors, place),
      scale(attributes, "SCALE", vectors, accessors, place);
  std::vector<Placement> maps;
  maps.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    maps.push_back(from_trs(translation.at(i), rotation.at(i), scale.at(i)));
  return maps;
}

}  // namespace provis
