#pragma once
// glTF documents put together in a test: JSON by hand, one binary buffer behind it.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "provis/vec3.hpp"
#include "tests/scene/files.hpp"

namespace provis {

using Json = nlohmann::json;

/// The component type of a C++ type.
template <class T>
constexpr int component_type();
template <>
constexpr int component_type<std::int8_t>() {
  return 5120;
}
template <>
constexpr int component_type<std::uint8_t>() {
  return 5121;
}
template <>
constexpr int component_type<std::int16_t>() {
  return 5122;
}
template <>
constexpr int component_type<std::uint16_t>() {
  return 5123;
}
template <>
constexpr int component_type<std::uint32_t>() {
  return 5125;
}
template <>
constexpr int component_type<float>() {
  return 5126;
}

class GltfBuilder {
 public:
  Json json = {{"asset", {{"version", "2.0"}}}};
  std::string binary;

  /// Adds to an array of the document and returns the position there.
  int add(const char* array, Json value) {
    json[array].push_back(std::move(value));
    return static_cast<int>(json[array].size()) - 1;
  }

  template <class T>
  int view(const std::vector<T>& values) {
    binary.append((4 - binary.size() % 4) % 4, '\0');
    const std::size_t offset = binary.size(), size = values.size() * sizeof(T);
    binary.append(reinterpret_cast<const char*>(values.data()), size);
    return add("bufferViews", {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
  }

  template <class T>
  int accessor(const char* type, std::size_t components, const std::vector<T>& values) {
    return add("accessors", {{"bufferView", view(values)},
                             {"componentType", component_type<T>()},
                             {"count", values.size() / components},
                             {"type", type}});
  }

  template <class T>
  int positions(const std::vector<T>& coordinates) {
    return accessor("VEC3", 3, coordinates);
  }
  template <class T>
  int indices(const std::vector<T>& values) {
    return accessor("SCALAR", 1, values);
  }

  /// Integers that stand for fractions of the largest.
  template <class T>
  int normalized(const char* type, std::size_t components, const std::vector<T>& values) {
    const int position = accessor(type, components, values);
    json["accessors"][position]["normalized"] = true;
    return position;
  }

  /// A mesh of one primitive; members are added to it.
  int mesh(int position_accessor, Json members = Json::object()) {
    members["attributes"]["POSITION"] = position_accessor;
    return add("meshes", {{"primitives", {std::move(members)}}});
  }

  /// A node that is a root of the only scene.
  int root(Json members) {
    const int node = add("nodes", std::move(members));
    if (!json.contains("scenes")) json["scenes"] = {{{"nodes", Json::array()}}};
    json["scenes"][0]["nodes"].push_back(node);
    return node;
  }

  std::string glb() const {
    Json document = json;
    if (!binary.empty() && !document.contains("buffers"))
      document["buffers"] = {{{"byteLength", binary.size()}}};
    std::string text = document.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string chunks = chunk(text, 0x4E4F534A);
    if (!binary.empty()) chunks += chunk(binary + std::string((4 - binary.size() % 4) % 4, '\0'), 0x004E4942);
    return "glTF" + bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(12 + chunks.size())}) + chunks;
  }

  Scene load(const LoadOptions& options = {}) const { return load_content("scene.glb", glb(), options); }
  Failure failure(const LoadOptions& options = {}) const { return load_failure("scene.glb", glb(), options); }

 private:
  static std::string chunk(const std::string& data, std::uint32_t type) {
    return bytes_of<std::uint32_t>({static_cast<std::uint32_t>(data.size()), type}) + data;
  }
};

/// Corners (0,0,0), (1,0,0), (2,0,0) and so on, so that an index can be read off a coordinate.
inline std::vector<float> numbered_positions(int count) {
  std::vector<float> coordinates;
  for (int i = 0; i < count; ++i) coordinates.insert(coordinates.end(), {static_cast<float>(i), 0.0f, 0.0f});
  return coordinates;
}

/// One triangle, placed by one node; for tests that break something about it.
inline GltfBuilder one_triangle(Json primitive = Json::object(), Json node = Json::object()) {
  GltfBuilder builder;
  node["mesh"] = builder.mesh(builder.positions<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}), std::move(primitive));
  builder.root(std::move(node));
  return builder;
}

}  // namespace provis

namespace Catch {
template <>
struct StringMaker<provis::Vec3d> {
  static std::string convert(const provis::Vec3d& p) { return fmt::format("({}, {}, {})", p.x, p.y, p.z); }
};
}  // namespace Catch
