#include "src/scene/gltf_reduce.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string_view>

#include "src/scene/failure.hpp"
#include "src/scene/gltf_fault.hpp"
#include "src/scene/reduce_compression.hpp"

namespace provis {
namespace {

using enum JsonKind;

constexpr JsonMember document_members[] = {{"scene", index}};
constexpr JsonMember asset_members[] = {{"version", text, true}, {"minVersion", text}};
constexpr JsonMember scene_members[] = {{"nodes", indices}};
constexpr JsonMember node_members[] = {{"mesh", index},
                                       {"skin", index},
                                       {"children", indices},
                                       {"matrix", numbers, false, 16},
                                       {"rotation", numbers, false, 4},
                                       {"scale", numbers, false, 3},
                                       {"translation", numbers, false, 3},
                                       {"weights", numbers}};
constexpr JsonMember mesh_members[] = {{"weights", numbers}};
constexpr JsonMember primitive_members[] = {{"material", index}, {"mode", index}};
constexpr JsonMember indices_members[] = {{"indices", index}};
constexpr JsonMember position_members[] = {{"POSITION", index}};
constexpr JsonMember skin_members[] = {{"inverseBindMatrices", index}, {"joints", indices, true}};
constexpr JsonMember accessor_members[] = {{"bufferView", index},  {"byteOffset", count},
                                           {"normalized", flag},   {"componentType", index, true},
                                           {"count", count, true}, {"type", text, true}};
constexpr JsonMember sparse_members[] = {{"count", small_count, true}};
constexpr JsonMember sparse_indices_members[] = {
    {"bufferView", index, true}, {"byteOffset", small_count}, {"componentType", index, true}};
constexpr JsonMember sparse_values_members[] = {{"bufferView", index, true}, {"byteOffset", small_count}};
constexpr JsonMember view_members[] = {
    {"buffer", index, true}, {"byteOffset", count}, {"byteLength", count, true}, {"byteStride", count}};
constexpr JsonMember material_members[] = {{"doubleSided", flag}, {"alphaMode", text}};
constexpr JsonMember transmission_members[] = {{"transmissionFactor", number}};

/// Extensions that a file may require: this program reads them, or they change neither the triangles nor what
/// they hide.
/// A name that ends in '_' stands for all that begin with it.
constexpr std::string_view known_extensions[] = {
    "KHR_mesh_quantization", "KHR_materials_",          "KHR_texture_",   "EXT_texture_",
    "KHR_lights_",           "KHR_animation_pointer",   "KHR_xmp",        "KHR_xmp_json_ld",
    "EXT_mesh_features",     "EXT_structural_metadata", "KHR_audio",      "KHR_draw_mode_hint",
    instancing_extension,    draco_extension,           meshopt_extension};

bool is_known(std::string_view extension) {
  return std::ranges::any_of(known_extensions, [extension](std::string_view known) {
    return known.ends_with('_') ? extension.starts_with(known) : extension == known;
  });
}

/// The extension's object at this object, or nullptr.
const Json* extension_of(const Json& object, const std::string& place, const char* name) {
  const Json* extensions = find_member(object, "extensions");
  if (extensions == nullptr) return nullptr;
  require_object(*extensions, place + ".extensions");
  return find_member(*extensions, name);
}

std::string place_of_extension(const std::string& place, const char* name) {
  return fmt::format("{}.extensions.{}", place, name);
}

/// A name is for messages and reports only: one of the wrong type is as good as none.
void keep_name(Json& reduced, const Json& object) {
  const Json* name = find_member(object, "name");
  if (name != nullptr && name->is_string()) reduced["name"] = *name;
}

Json reduced_scene(const Json& scene, const std::string& place) {
  Json reduced = checked_members(scene, place, scene_members);
  keep_name(reduced, scene);
  return reduced;
}

/// The members that decide geometry by that name, all of them accessors.
Json reduced_attributes(const Json& attributes, const std::string& place,
                        bool (*decides)(std::string_view name)) {
  require_object(attributes, place);
  Json reduced = Json::object();
  for (const auto& [name, accessor] : attributes.items()) {
    if (!decides(name)) continue;
    const JsonMember member[] = {{name.c_str(), index}};
    reduced.update(checked_members(attributes, place, member));
  }
  return reduced;
}

bool decides_primitive(std::string_view name) {
  return name == "POSITION" || name == radius_attribute || name.starts_with("JOINTS_") ||
         name.starts_with("WEIGHTS_");
}

/// The number of instances is that of any attribute, so all of them are kept.
Json reduced_instancing(const Json& extension, const std::string& place) {
  require_object(extension, place);
  const Json* attributes = find_member(extension, "attributes");
  if (attributes == nullptr) fail_invalid(place, "attributes is missing");
  Json reduced =
      reduced_attributes(*attributes, place + ".attributes", [](std::string_view) { return true; });
  if (reduced.empty()) fail_invalid(place, "no attributes, so no number of instances");
  return {{"attributes", std::move(reduced)}};
}

void check_affine(const Json& matrix, const std::string& place) {
  const auto m = [&matrix](std::size_t i) { return matrix[i].get<double>(); };
  if (m(3) != 0 || m(7) != 0 || m(11) != 0 || m(15) != 1)
    fail_invalid(place, fmt::format("the last row is ({}, {}, {}, {})", m(3), m(7), m(11), m(15)));
}

Json reduced_node(const Json& node, const std::string& place) {
  Json reduced = checked_members(node, place, node_members);
  if (reduced.contains("matrix") &&
      (reduced.contains("translation") || reduced.contains("rotation") || reduced.contains("scale")))
    fail_invalid(place, "matrix beside translation, rotation or scale");
  if (const Json* matrix = find_member(reduced, "matrix")) check_affine(*matrix, place + ".matrix");
  keep_name(reduced, node);
  if (const Json* instancing = extension_of(node, place, instancing_extension))
    reduced["extensions"][instancing_extension] =
        reduced_instancing(*instancing, place_of_extension(place, instancing_extension));
  return reduced;
}

/// Of every morph target the positions only.
Json reduced_targets(const Json& targets, const std::string& place) {
  require_array(targets, place);
  Json reduced = Json::array();
  for (std::size_t i = 0; i < targets.size(); ++i)
    reduced.push_back(checked_members(targets[i], fmt::format("{}[{}]", place, i), position_members));
  return reduced;
}

Json reduced_primitive(const Json& primitive, const std::string& place) {
  Json reduced = checked_members(primitive, place, primitive_members);
  if (const Json* targets = find_member(primitive, "targets"))
    reduced["targets"] = reduced_targets(*targets, place + ".targets");
  const Json* attributes = find_member(primitive, "attributes");
  if (attributes == nullptr) fail_invalid(place, "attributes is missing");
  reduced["attributes"] = reduced_attributes(*attributes, place + ".attributes", decides_primitive);
  if (const Json* draco = extension_of(primitive, place, draco_extension))
    reduced["extensions"][draco_extension] =
        reduced_draco(*draco, reduced["attributes"], place_of_extension(place, draco_extension));
  const Json own_indices = checked_members(primitive, place, indices_members);
  if (const Json* accessor = find_member(own_indices, "indices"))
    reduced["attributes"][indices_attribute] = *accessor;
  return reduced;
}

/// The same, but where it fails the placeholder keeps the failure: whatever no triangle needs may be broken.
/// Wrong kinds are kept only if that is asked for.
template <class ReduceOne>
auto or_faulty(bool keep_wrong_kinds, const ReduceOne& reduce_one, const Json& placeholder) {
  return [=](const Json& object, const std::string& place) {
    try {
      return reduce_one(object, place);
    } catch (const WrongKind& error) {
      if (!keep_wrong_kinds) throw;
      return faulty(placeholder, error);
    } catch (const Error& error) {
      return faulty(placeholder, error);
    }
  };
}

Json reduced_mesh(const Json& mesh, const std::string& place, bool keep_wrong_kinds) {
  Json reduced = checked_members(mesh, place, mesh_members);
  const Json* primitives = find_member(mesh, "primitives");
  if (primitives == nullptr) fail_invalid(place, "primitives is missing");
  require_array(*primitives, place + ".primitives");
  reduced["primitives"] = Json::array();
  const auto reduce = or_faulty(keep_wrong_kinds, reduced_primitive, {{"attributes", Json::object()}});
  for (std::size_t i = 0; i < primitives->size(); ++i)
    reduced["primitives"].push_back(reduce((*primitives)[i], fmt::format("{}.primitives[{}]", place, i)));
  return reduced;
}

Json reduced_skin(const Json& skin, const std::string& place) {
  return checked_members(skin, place, skin_members);
}

Json reduced_sparse(const Json& sparse, const std::string& place) {
  Json reduced = checked_members(sparse, place, sparse_members);
  const Json* sparse_indices = find_member(sparse, "indices");
  const Json* values = find_member(sparse, "values");
  if (sparse_indices == nullptr || values == nullptr) fail_invalid(place, "indices or values is missing");
  reduced["indices"] = checked_members(*sparse_indices, place + ".indices", sparse_indices_members);
  reduced["values"] = checked_members(*values, place + ".values", sparse_values_members);
  return reduced;
}

Json reduced_accessor(const Json& accessor, const std::string& place) {
  Json reduced = checked_members(accessor, place, accessor_members);
  constexpr std::array known = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  if (std::ranges::find(known, reduced["type"].get_ref<const std::string&>()) == known.end())
    fail_invalid(place + ".type", fmt::format("unknown type {}", reduced["type"].dump()));
  const int component = reduced["componentType"].get<int>();
  if (component < 5120 || component > 5126)
    fail_invalid(place + ".componentType", fmt::format("unknown component type {}", component));
  if (const Json* sparse = find_member(accessor, "sparse"))
    reduced["sparse"] = reduced_sparse(*sparse, place + ".sparse");
  return reduced;
}

Json reduced_view(const Json& view, const std::string& place) {
  Json reduced = checked_members(view, place, view_members);
  if (const Json* stride = find_member(reduced, "byteStride")) {
    const auto bytes = stride->get<std::uint64_t>();
    if (bytes > 252 || bytes % 4 != 0)
      fail_invalid(place + ".byteStride", fmt::format("{} is no multiple of 4 up to 252", bytes));
  }
  if (const Json* meshopt = extension_of(view, place, meshopt_extension))
    reduced["extensions"][meshopt_extension] =
        reduced_meshopt(*meshopt, place_of_extension(place, meshopt_extension));
  return reduced;
}

Json reduced_material(const Json& material, const std::string& place) {
  Json reduced = checked_members(material, place, material_members);
  const std::string mode = reduced.value("alphaMode", "OPAQUE");
  if (mode != "OPAQUE" && mode != "MASK" && mode != "BLEND")
    fail_invalid(place + ".alphaMode", fmt::format("unknown mode \"{}\"", mode));
  if (const Json* transmission = extension_of(material, place, transmission_extension))
    reduced["extensions"][transmission_extension] = checked_members(
        *transmission, place_of_extension(place, transmission_extension), transmission_members);
  return reduced;
}

/// Digits, a dot, digits.
bool is_version(std::string_view text) {
  const std::size_t dot = text.find('.');
  const auto digits = [](std::string_view part) {
    return !part.empty() && part.find_first_not_of("0123456789") == std::string_view::npos;
  };
  return dot != std::string_view::npos && digits(text.substr(0, dot)) && digits(text.substr(dot + 1));
}

Json reduced_asset(const Json& document) {
  const Json* asset = find_member(document, "asset");
  if (asset == nullptr) fail_invalid("asset", "missing: this JSON is no glTF");
  require_object(*asset, "asset");
  if (const Json* version = find_member(*asset, "version"); version != nullptr && version->is_number())
    fail_unsupported("asset.version",
                     fmt::format("the number {}, as drafts of glTF 1 had it", version->dump()));
  Json reduced = checked_members(*asset, "asset", asset_members);
  const std::string version = reduced["version"], least = reduced.value("minVersion", "2.0");
  if (!is_version(version)) fail_invalid("asset.version", fmt::format("\"{}\" is no version", version));
  if (!version.starts_with("2.")) fail_unsupported("asset.version", fmt::format("glTF {}", version));
  if (least != "2.0") fail_unsupported("asset.minVersion", fmt::format("glTF {} or later", least));
  return reduced;
}

void check_required_extensions(const Json& document) {
  const Json* required = find_member(document, "extensionsRequired");
  if (required == nullptr) return;
  require_array(*required, "extensionsRequired");
  for (const Json& extension : *required) {
    if (!extension.is_string())
      fail_invalid("extensionsRequired", fmt::format("{} instead of a string", extension.type_name()));
    const std::string& name = extension.get_ref<const std::string&>();
    if (!is_known(name)) fail_unsupported("extensionsRequired", fmt::format("the file requires {}", name));
  }
}

template <class ReduceOne>
void reduce_all(Json& reduced, const Json& document, const char* name, const ReduceOne& reduce_one) {
  const Json* all = find_member(document, name);
  if (all == nullptr) return;
  require_array(*all, name);
  Json& kept = reduced[name] = Json::array();
  for (std::size_t i = 0; i < all->size(); ++i)
    kept.push_back(reduce_one((*all)[i], fmt::format("{}[{}]", name, i)));
}

}  // namespace

Json reduced_document(const Json& document, bool keep_wrong_kinds) {
  require_object(document, "document");
  Json asset = reduced_asset(document);
  check_required_extensions(document);
  Json reduced = checked_members(document, "document", document_members);
  reduced["asset"] = std::move(asset);
  reduce_all(reduced, document, "scenes", reduced_scene);
  reduce_all(reduced, document, "nodes", reduced_node);
  const auto mesh = [keep_wrong_kinds](const Json& object, const std::string& place) {
    return reduced_mesh(object, place, keep_wrong_kinds);
  };
  const auto reduce = [&](const char* name, const auto& reduce_one, const Json& placeholder) {
    reduce_all(reduced, document, name, or_faulty(keep_wrong_kinds, reduce_one, placeholder));
  };
  reduce("meshes", mesh, {{"primitives", Json::array()}});
  // Of skins, which are read for meshes that have joints only, not even the kinds matter before.
  reduce_all(reduced, document, "skins", or_faulty(true, reduced_skin, {{"joints", Json::array()}}));
  reduce("accessors", reduced_accessor, {{"componentType", 5126}, {"count", 0}, {"type", "SCALAR"}});
  reduce("bufferViews", reduced_view, {{"buffer", 0}, {"byteLength", 0}});
  reduce("materials", reduced_material, Json::object());
  return reduced;
}

}  // namespace provis
