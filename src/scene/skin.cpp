#include "src/scene/skin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "src/scene/failure.hpp"
#include "src/scene/gltf_fault.hpp"
#include "src/scene/gltf_primitive.hpp"

namespace provis {
namespace {

constexpr std::size_t influences_per_set = 4;

std::vector<Placement> inverse_bind_maps(const tinygltf::Skin& skin, AccessorReader& accessors,
                                         const std::string& place) {
  constexpr std::size_t entries = 16;
  constexpr ElementKind kind = {"inverse bind matrices", TINYGLTF_TYPE_MAT4, float_components};
  std::vector<Placement> maps(skin.joints.size());
  if (skin.inverseBindMatrices < 0) return maps;
  const auto values = accessors.numbers(skin.inverseBindMatrices, kind, place + ".inverseBindMatrices");
  if (values.size() < maps.size() * entries)
    fail_invalid(place,
                 fmt::format("{} inverse bind matrices for {} joints", values.size() / entries, maps.size()));
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(i * entries);
    const std::vector<double> m(first, first + entries);
    if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
      fail_invalid(
          fmt::format("accessors[{}]", skin.inverseBindMatrices),
          fmt::format("the last row of element {} is ({}, {}, {}, {})", i, m[3], m[7], m[11], m[15]));
    maps[i] = from_columns(m);
  }
  return maps;
}

std::size_t sets_named(const tinygltf::Primitive& primitive, const char* prefix) {
  return static_cast<std::size_t>(std::ranges::count_if(
      primitive.attributes, [prefix](const auto& entry) { return entry.first.starts_with(prefix); }));
}

/// How many sets there are; they must be numbered from 0, joints and weights alike.
std::size_t set_count(const tinygltf::Primitive& primitive, const std::string& place) {
  std::size_t sets = 0;
  while (attribute(primitive, fmt::format("JOINTS_{}", sets)) >= 0 &&
         attribute(primitive, fmt::format("WEIGHTS_{}", sets)) >= 0)
    ++sets;
  if (sets == 0) fail_invalid(place, "JOINTS_0 or WEIGHTS_0 is missing, but a node places it with a skin");
  if (sets_named(primitive, "JOINTS_") != sets || sets_named(primitive, "WEIGHTS_") != sets)
    fail_invalid(place, fmt::format("JOINTS_{0} or WEIGHTS_{0} is missing, but there are others", sets));
  return sets;
}

std::vector<double> read_influences(int accessor, const ElementKind& kind, std::size_t vertices,
                                    AccessorReader& accessors, const std::string& place) {
  std::vector<double> values = accessors.numbers(accessor, kind, place + ".attributes");
  if (values.size() != vertices * influences_per_set)
    fail_invalid(place, fmt::format("{}: {} elements for {} vertices", accessors.place_of(accessor),
                                    values.size() / influences_per_set, vertices));
  return values;
}

}  // namespace

std::vector<Placement> joint_maps(int skin, const tinygltf::Model& model, Pose& pose,
                                  AccessorReader& accessors, const std::string& wanted_by) {
  if (static_cast<std::size_t>(skin) >= model.skins.size())
    fail_invalid(wanted_by, fmt::format("skin {} of {} does not exist", skin, model.skins.size()));
  const tinygltf::Skin& s = model.skins[static_cast<std::size_t>(skin)];
  check_usable(s.extras);
  const std::string place = fmt::format("skins[{}]", skin);
  std::vector<Placement> maps = inverse_bind_maps(s, accessors, place);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (static_cast<std::size_t>(s.joints[i]) >= model.nodes.size())
      fail_invalid(fmt::format("{}.joints[{}]", place, i),
                   fmt::format("node {} of {} does not exist", s.joints[i], model.nodes.size()));
    maps[i] = compose(pose.world(s.joints[i]), maps[i]);
    if (!maps[i].finite()) fail_invalid(fmt::format("{}.joints[{}]", place, i), "the joint matrix overflows");
  }
  return maps;
}

SkinnedPrimitive::SkinnedPrimitive(const tinygltf::Primitive& primitive, std::size_t vertices,
                                   std::size_t joints, AccessorReader& accessors, const std::string& place) {
  constexpr ElementKind joint_kind = {"joints", TINYGLTF_TYPE_VEC4, plain_unsigned};
  constexpr ElementKind weight_kind = {"joint weights", TINYGLTF_TYPE_VEC4,
                                       float_components | normalized_unsigned};
  sets_.resize(set_count(primitive, place));
  for (std::size_t n = 0; n < sets_.size(); ++n) {
    const int joint_accessor = attribute(primitive, fmt::format("JOINTS_{}", n));
    Set& set = sets_[n];
    set.joints = read_influences(joint_accessor, joint_kind, vertices, accessors, place);
    set.weights = read_influences(attribute(primitive, fmt::format("WEIGHTS_{}", n)), weight_kind, vertices,
                                  accessors, place);
    for (std::size_t i = 0; i < set.joints.size(); ++i)
      if (set.weights[i] != 0 && set.joints[i] >= static_cast<double>(joints))
        fail_invalid(place,
                     fmt::format("{}: element {} names joint {} of {}", accessors.place_of(joint_accessor),
                                 i / influences_per_set, set.joints[i], joints));
  }
}

Placement SkinnedPrimitive::map_of(std::size_t vertex, const std::vector<Placement>& joints) const {
  Placement map;
  map.rows = {};
  for (const Set& set : sets_)
    for (std::size_t k = 0; k < influences_per_set; ++k) {
      const double weight = set.weights[vertex * influences_per_set + k];
      if (weight == 0) continue;
      const Placement& joint = joints[static_cast<std::size_t>(set.joints[vertex * influences_per_set + k])];
      for (std::size_t i = 0; i < map.rows.size(); ++i)
        for (std::size_t j = 0; j < map.rows[i].size(); ++j) map.rows[i][j] += weight * joint.rows[i][j];
    }
  return map;
}

}  // namespace provis
