#include <fmt/format.h>

#include <limits>
#include <optional>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"
#include "src/scene/gltf_document.hpp"
#include "src/scene/gltf_nodes.hpp"
#include "src/scene/gltf_primitive.hpp"
#include "src/scene/gltf_reduce.hpp"
#include "src/scene/scene_source.hpp"

namespace provis {
namespace {

/// Geometry that follows a node in ways this program does not compute.
void check_placeable(const tinygltf::Model& model, const tinygltf::Node& node, const std::string& place) {
  if (node.extensions.count(instancing_extension) != 0)
    fail_unsupported(place, fmt::format("instances by {}", instancing_extension));
  if (node.skin >= 0) fail_unsupported(place, "a skinned mesh");
  const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
  for (std::size_t p = 0; p < mesh.primitives.size(); ++p)
    for (std::size_t t = 0; t < mesh.primitives[p].targets.size(); ++t) {
      const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
      if (t < weights.size() && weights[t] != 0)
        fail_unsupported(place, fmt::format("meshes[{}].primitives[{}] has morph target {} of weight {}",
                                            node.mesh, p, t, weights[t]));
    }
}

class GltfLoader {
 public:
  GltfLoader(ByteSpan file, const std::filesystem::path& folder)
      : document_(read_gltf(file, folder)),
        model_(document_.model),
        accessors_(model_, document_.buffers, file.size()),
        decoded_(model_.meshes.size()) {}

  SceneArrays load() {
    const std::vector<PlacedNode> nodes = placed_meshes(model_);
    for (const PlacedNode& node : nodes) prepare(node);
    reserve();
    for (const PlacedNode& node : nodes) place(node);
    for (const tinygltf::Node& node : model_.nodes) arrays_.node_names.push_back(node.name);
    return std::move(arrays_);
  }

 private:
  int mesh_of(const PlacedNode& node) const { return model_.nodes[static_cast<std::size_t>(node.node)].mesh; }

  const std::vector<Vec3d>& positions_of(const DecodedPrimitive& primitive) {
    return accessors_.positions(primitive.positions, "");
  }

  /// Decodes the node's mesh unless another node did, and counts what it adds.
  void prepare(const PlacedNode& placed) {
    const tinygltf::Node& node = model_.nodes[static_cast<std::size_t>(placed.node)];
    const std::string place = fmt::format("nodes[{}]", placed.node);
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (mesh >= model_.meshes.size())
      fail_invalid(place, fmt::format("mesh {} of {} does not exist", node.mesh, model_.meshes.size()));
    check_placeable(model_, node, place);
    if (!decoded_[mesh]) decoded_[mesh] = decode_mesh(mesh);
    for (const DecodedPrimitive& primitive : *decoded_[mesh]) {
      triangle_count_ += primitive.triangles.size();
      if (primitive.positions >= 0) vertex_count_ += positions_of(primitive).size();
      arrays_.skipped.points += primitive.skipped.points;
      arrays_.skipped.lines += primitive.skipped.lines;
    }
  }

  std::vector<DecodedPrimitive> decode_mesh(std::size_t mesh) {
    std::vector<DecodedPrimitive> primitives;
    for (std::size_t p = 0; p < model_.meshes[mesh].primitives.size(); ++p) {
      const std::string place = fmt::format("meshes[{}].primitives[{}]", mesh, p);
      primitives.push_back(decode_primitive(model_, model_.meshes[mesh].primitives[p], accessors_, place));
    }
    return primitives;
  }

  /// Instances multiply what the file holds: count in 64 bits before any memory is taken.
  void reserve() {
    constexpr std::uint64_t most = std::numeric_limits<PrimitiveId>::max();
    if (triangle_count_ > most || vertex_count_ > most)
      fail_unsupported("scene", fmt::format("{} triangles with {} vertices; ids end at 2^32 - 1",
                                            triangle_count_, vertex_count_));
    arrays_.vertices.reserve(vertex_count_);
    arrays_.triangles.reserve(triangle_count_);
    arrays_.triangle_flags.reserve(triangle_count_);
  }

  void place(const PlacedNode& node) {
    const bool mirrored = determinant_sign(node.world) == Sign::negative;
    const int mesh = mesh_of(node);
    const std::vector<DecodedPrimitive>& primitives = *decoded_[static_cast<std::size_t>(mesh)];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      if (primitives[p].positions < 0) continue;
      const SourceRange source{static_cast<PrimitiveId>(arrays_.triangles.size()),
                               static_cast<std::uint32_t>(primitives[p].triangles.size()), node.node, mesh,
                               static_cast<std::int32_t>(p)};
      if (source.count > 0) arrays_.sources.push_back(source);
      append_triangles(primitives[p], mirrored);
      append_vertices(positions_of(primitives[p]), node.world, source);
    }
  }

  /// A mirroring map turns front into back; swapping two corners turns it round again.
  void append_triangles(const DecodedPrimitive& primitive, bool mirrored) {
    const auto first = static_cast<std::uint32_t>(arrays_.vertices.size());
    for (const auto& [a, b, c] : primitive.triangles) {
      arrays_.triangles.push_back({first + a, first + (mirrored ? c : b), first + (mirrored ? b : c)});
      arrays_.triangle_flags.push_back(primitive.flags);
    }
  }

  void append_vertices(const std::vector<Vec3d>& positions, const Placement& world,
                       const SourceRange& source) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
      const Vec3d v = apply(world, positions[i]);
      if (!finite(v))
        fail_invalid(fmt::format("nodes[{}]", source.node),
                     fmt::format("vertex {} of meshes[{}].primitives[{}] overflows", i, source.mesh,
                                 source.primitive));
      arrays_.vertices.push_back(v);
    }
  }

  GltfDocument document_;
  const tinygltf::Model& model_;
  AccessorReader accessors_;
  std::vector<std::optional<std::vector<DecodedPrimitive>>>
      decoded_;  ///< by mesh; empty where no node needs it
  std::uint64_t vertex_count_ = 0, triangle_count_ = 0;
  SceneArrays arrays_;
};

}  // namespace

SceneSource load_gltf(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options) {
  static_cast<void>(options);
  return {GltfLoader(file, folder).load(), std::nullopt};
}

}  // namespace provis
