#pragma once
// glTF documents whose geometry is compressed in the test by libdraco's encoder.

#include <draco/compression/expert_encode.h>
#include <draco/mesh/mesh.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "tests/scene/gltf_builder.hpp"
#include "tests/scene/grid.hpp"

namespace provis {

inline constexpr int sequential = draco::MESH_SEQUENTIAL_ENCODING;
inline constexpr int edgebreaker = draco::MESH_EDGEBREAKER_ENCODING;

template <class T>
constexpr draco::DataType draco_type();
template <>
constexpr draco::DataType draco_type<std::uint8_t>() {
  return draco::DT_UINT8;
}
template <>
constexpr draco::DataType draco_type<std::int16_t>() {
  return draco::DT_INT16;
}
template <>
constexpr draco::DataType draco_type<std::uint16_t>() {
  return draco::DT_UINT16;
}
template <>
constexpr draco::DataType draco_type<float>() {
  return draco::DT_FLOAT32;
}

/// A mesh to be encoded; its attributes have the ids 0, 1 and so on.
class DracoEncoded {
 public:
  DracoEncoded(std::size_t points, const std::vector<unsigned>& indices) {
    mesh_.set_num_points(static_cast<std::uint32_t>(points));
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      mesh_.AddFace({draco::PointIndex(indices[i]), draco::PointIndex(indices[i + 1]),
                     draco::PointIndex(indices[i + 2])});
  }

  /// Positions only.
  explicit DracoEncoded(const Grid& grid) : DracoEncoded(grid.vertex_count(), grid.indices) {
    add<float>(draco::GeometryAttribute::POSITION, 3, grid.coordinates);
  }

  template <class T>
  DracoEncoded& add(draco::GeometryAttribute::Type type, int components, const std::vector<T>& values,
                    bool normalized = false) {
    draco::GeometryAttribute attribute;
    const auto size = static_cast<std::int64_t>(sizeof(T)) * components;
    attribute.Init(type, nullptr, static_cast<std::uint8_t>(components), draco_type<T>(), normalized, size,
                   0);
    const int id = mesh_.AddAttribute(attribute, true, mesh_.num_points());
    for (std::uint32_t i = 0; i < mesh_.num_points(); ++i)
      mesh_.attribute(id)->SetAttributeValue(draco::AttributeValueIndex(i),
                                             &values[i * static_cast<std::size_t>(components)]);
    return *this;
  }

  draco::Mesh& mesh() { return mesh_; }

  /// bits 0: floats as they are. Fast encoding keeps attributes in one table; slow encoding uses valences.
  std::vector<std::uint8_t> bytes(int method, int bits = 0, int speed = 5) const {
    draco::ExpertEncoder encoder(mesh_);
    encoder.SetEncodingMethod(method);
    encoder.SetSpeedOptions(speed, speed);
    if (bits > 0) {
      const float origin[] = {0, 0, 0};
      encoder.SetAttributeExplicitQuantization(0, bits, 3, origin, 10.0f);
    }
    draco::EncoderBuffer buffer;
    const draco::Status status = encoder.EncodeToBuffer(&buffer);
    REQUIRE(status.ok());
    return {buffer.data(), buffer.data() + buffer.size()};
  }

 private:
  draco::Mesh mesh_;
};

/// A document of one primitive over Draco data, whose accessors declare so many points and triangles and
/// have no data of their own: accessor 0 is POSITION, 1 the indices.
inline GltfBuilder draco_document(const std::vector<std::uint8_t>& compressed, std::size_t points,
                                  std::size_t triangles) {
  GltfBuilder builder;
  const int view = builder.view(compressed);
  builder.add("accessors", {{"componentType", 5126}, {"count", points}, {"type", "VEC3"}});
  builder.add("accessors", {{"componentType", 5125}, {"count", 3 * triangles}, {"type", "SCALAR"}});
  Json extension = {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}};
  builder.root({{"mesh", builder.mesh(0, {{"indices", 1},
                                          {"extensions", {{"KHR_draco_mesh_compression", extension}}}})}});
  return builder;
}

inline GltfBuilder draco_document(const Grid& grid, int method, int bits = 0, int speed = 5) {
  return draco_document(DracoEncoded(grid).bytes(method, bits, speed), grid.vertex_count(),
                        grid.triangles().size());
}

inline Json& primitive_of(GltfBuilder& builder, std::size_t mesh = 0) {
  return builder.json["meshes"][mesh]["primitives"][0];
}

inline Json& draco_of(GltfBuilder& builder, std::size_t mesh = 0) {
  return primitive_of(builder, mesh)["extensions"]["KHR_draco_mesh_compression"];
}

using Corners = std::array<std::array<double, 3>, 3>;

/// The triangles by their corners' coordinates, each from its smallest corner on, sorted: Draco keeps neither
/// the order of triangles nor that of points.
inline std::vector<Corners> soup(const std::vector<Vec3d>& vertices, const std::vector<Triangle>& triangles) {
  std::vector<Corners> all;
  for (const Triangle& t : triangles) {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = {vertices[t[k]].x, vertices[t[k]].y, vertices[t[k]].z};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    all.push_back(corners);
  }
  std::ranges::sort(all);
  return all;
}
inline std::vector<Corners> soup(const Scene& scene) {
  return soup(scene.arrays().vertices, scene.arrays().triangles);
}
inline std::vector<Corners> soup(const Grid& grid) { return soup(grid.vertices(), grid.triangles()); }

}  // namespace provis
