#include <fmt/format.h>

#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "src/scene/animation.hpp"
#include "src/scene/failure.hpp"
#include "src/scene/gltf_assembly.hpp"
#include "src/scene/gltf_document.hpp"
#include "src/scene/gltf_draco.hpp"
#include "src/scene/gltf_fault.hpp"
#include "src/scene/gltf_nodes.hpp"
#include "src/scene/gltf_primitive.hpp"
#include "src/scene/gltf_reduce.hpp"
#include "src/scene/instances.hpp"
#include "src/scene/morph.hpp"
#include "src/scene/pose.hpp"
#include "src/scene/scene_source.hpp"
#include "src/scene/skin.hpp"

namespace provis {
namespace {

std::string place_of(int node) { return fmt::format("nodes[{}]", node); }

std::string place_of(int mesh, std::size_t primitive) {
  return fmt::format("meshes[{}].primitives[{}]", mesh, primitive);
}

/// A node's mesh at one place.
struct Copy {
  Copy(const Placement& global, int index)
      : world(global), mirrored(determinant_sign(global) == Sign::negative), instance(index) {}

  Placement world;
  bool mirrored;
  int instance;  ///< -1 where the node is not instanced
};

class GltfLoader {
 public:
  GltfLoader(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options)
      : options_(options),
        bytes_(file.size()),
        document_(read_gltf(file, folder, options)),
        model_(document_.model),
        views_(model_, document_.buffers),
        accessors_(model_, views_, file.size()),
        draco_(views_, accessors_),
        scene_(chosen_scene(model_, options.scene)),
        parents_(node_parents(model_)),
        pose_(model_, parents_, animated()),
        decoded_(model_.meshes.size()),
        assembly_(options.radius.value_or(0)) {}

  SceneArrays load() {
    std::vector<int> nodes = mesh_nodes(model_, parents_, scene_);
    std::erase_if(nodes, [this](int node) { return !attempt([&] { prepare(node); }, place_of(node)); });
    assembly_.set_bytes(bytes_ + document_.buffers.loaded_bytes());
    for (const int node : nodes) expect(node);
    assembly_.reserve();
    for (const int node : nodes) attempt([&] { place(node); }, place_of(node));
    SceneArrays arrays = assembly_.finish();
    for (const tinygltf::Node& node : model_.nodes) arrays.node_names.push_back(node.name);
    arrays.notes = notes();
    return arrays;
  }

 private:
  AnimatedNodes animated() {
    if (!document_.animation) return {};
    return animated_nodes(*document_.animation, *options_.time, model_, accessors_);
  }

  std::string place_in(int node, std::size_t p) const {
    return fmt::format("{}: {}", place_of(node), place_of(node_at(node).mesh, p));
  }

  const tinygltf::Node& node_at(int node) const { return model_.nodes[static_cast<std::size_t>(node)]; }

  const tinygltf::Primitive& primitive_at(int mesh, std::size_t p) const {
    return model_.meshes[static_cast<std::size_t>(mesh)].primitives[p];
  }

  /// Of a mesh that was decoded.
  const std::vector<DecodedPrimitive>& decoded(int mesh) const {
    return *decoded_[static_cast<std::size_t>(mesh)];
  }

  const std::vector<Vec3d>& positions_of(const DecodedPrimitive& primitive) {
    return accessors_.positions(primitive.positions, "");
  }

  /// Takes the step, and says whether it succeeded. A failure of the file is listed where that is asked for,
  /// at that place; any other goes on.
  template <class Step>
  bool attempt(const Step& step, const std::string& place) {
    try {
      step();
      return true;
    } catch (const Error& error) {
      const bool of_the_file =
          error.code() == Error::Code::invalid_input || error.code() == Error::Code::unsupported;
      if (!options_.skip_invalid || !of_the_file) throw;
      assembly_.leave_out({place, error.place() == place ? what_of(error) : error.what()});
      return false;
    }
  }

  /// Decodes the node's mesh unless another node did.
  void prepare(int index) {
    const tinygltf::Node& node = node_at(index);
    const auto mesh = static_cast<std::size_t>(node.mesh);
    if (mesh >= model_.meshes.size())
      fail_invalid(place_of(index),
                   fmt::format("mesh {} of {} does not exist", node.mesh, model_.meshes.size()));
    if (is_instanced(node) && node.skin >= 0)
      fail_unsupported(place_of(index), fmt::format("{} of a skinned mesh", instancing_extension));
    check_usable(model_.meshes[mesh].extras);
    if (!decoded_[mesh]) decoded_[mesh] = decode_mesh(mesh);
    if (is_instanced(node)) instance_maps(node, accessors_, place_of(index));
  }

  /// Counts what the node adds.
  void expect(int index) {
    const tinygltf::Node& node = node_at(index);
    const std::size_t copies =
        is_instanced(node) ? instance_maps(node, accessors_, place_of(index)).size() : 1;
    for (const DecodedPrimitive& primitive : decoded(node.mesh))
      assembly_.expect(primitive, primitive.positions < 0 ? 0 : positions_of(primitive).size(), copies);
  }

  std::vector<DecodedPrimitive> decode_mesh(std::size_t mesh) {
    std::vector<DecodedPrimitive> primitives(model_.meshes[mesh].primitives.size());
    for (std::size_t p = 0; p < primitives.size(); ++p)
      attempt([&] { primitives[p] = decode(mesh, p); }, place_of(static_cast<int>(mesh), p));
    return primitives;
  }

  DecodedPrimitive decode(std::size_t mesh, std::size_t p) {
    tinygltf::Primitive& primitive = document_.model.meshes[mesh].primitives[p];
    const std::string place = place_of(static_cast<int>(mesh), p);
    check_usable(primitive.extras);
    draco_.decompress(primitive, place);
    return decode_primitive(model_, primitive, accessors_, place, options_.radius.has_value());
  }

  void place(int node) {
    if (node_at(node).skin >= 0)
      place_skinned(node);
    else if (is_instanced(node_at(node)))
      place_instances(node);
    else
      place_once(node);
  }

  void place_once(int node) { place_copy(node, shaped_primitives(node), Copy(pose_.world(node), -1)); }

  void place_instances(int node) {
    const std::vector<Placement> maps = instance_maps(node_at(node), accessors_, place_of(node));
    const std::vector<ShapedPrimitive> primitives = shaped_primitives(node);
    for (std::size_t i = 0; i < maps.size(); ++i) {
      const auto place_instance = [&] {
        const Placement world = compose(pose_.world(node), maps[i]);
        if (!world.finite())
          fail_invalid(place_of(node), fmt::format("the global matrix of instance {} overflows", i));
        place_copy(node, primitives, Copy(world, static_cast<int>(i)));
      };
      attempt(place_instance, place_of(node));
    }
  }

  void place_skinned(int node) {
    const std::vector<Placement>& joints = joints_of(node);
    const Copy copy(pose_.world(node), -1);
    for (std::size_t p = 0; p < decoded(node_at(node).mesh).size(); ++p)
      attempt([&] { place_skinned_primitive(node, p, copy, joints); }, place_in(node, p));
  }

  /// Only the joints move a skinned vertex; the node's own map decides the winding and nothing else.
  void place_skinned_primitive(int node, std::size_t p, const Copy& copy,
                               const std::vector<Placement>& joints) {
    const int mesh = node_at(node).mesh;
    const DecodedPrimitive& primitive = decoded(mesh)[p];
    if (primitive.shape == Shape::nothing) return;
    const auto morphed = morphed_positions(node, p);
    const std::vector<Vec3d>& positions = morphed ? *morphed : positions_of(primitive);
    const SkinnedPrimitive skinned(primitive_at(mesh, p), positions.size(), joints.size(), accessors_,
                                   place_of(mesh, p));
    const auto map_of = [&](std::size_t vertex) { return skinned.map_of(vertex, joints); };
    assembly_.add(primitive, positions, map_of, copy.mirrored, source(node, p, copy.instance));
  }

  /// Kept, since many nodes may share a skin.
  const std::vector<Placement>& joints_of(int node) {
    const int skin = node_at(node).skin;
    auto found = joints_.find(skin);
    if (found == joints_.end())
      found = joints_.emplace(skin, joint_maps(skin, model_, pose_, accessors_, place_of(node))).first;
    return found->second;
  }

  /// A primitive of a node's mesh, morphed as that node wants it.
  struct ShapedPrimitive {
    std::size_t index;
    std::optional<std::vector<Vec3d>> morphed;  ///< nothing where the positions stay as they are
  };

  std::vector<ShapedPrimitive> shaped_primitives(int node) {
    std::vector<ShapedPrimitive> shaped;
    for (std::size_t p = 0; p < decoded(node_at(node).mesh).size(); ++p)
      attempt([&] { shaped.push_back({p, morphed_positions(node, p)}); }, place_in(node, p));
    return shaped;
  }

  void place_copy(int node, const std::vector<ShapedPrimitive>& primitives, const Copy& copy) {
    for (const ShapedPrimitive& primitive : primitives)
      attempt([&] { place_primitive(node, primitive, copy); }, place_in(node, primitive.index));
  }

  void place_primitive(int node, const ShapedPrimitive& shaped, const Copy& copy) {
    const DecodedPrimitive& primitive = decoded(node_at(node).mesh)[shaped.index];
    if (primitive.shape == Shape::nothing) return;
    const auto map_of = [&copy](std::size_t) -> const Placement& { return copy.world; };
    assembly_.add(primitive, shaped.morphed ? *shaped.morphed : positions_of(primitive), map_of,
                  copy.mirrored, source(node, shaped.index, copy.instance));
  }

  /// Nothing where the primitive's own positions stay as they are.
  std::optional<std::vector<Vec3d>> morphed_positions(int node, std::size_t p) {
    const int mesh = node_at(node).mesh;
    const DecodedPrimitive& primitive = decoded(mesh)[p];
    if (primitive.shape == Shape::nothing) return std::nullopt;
    return morphed(positions_of(primitive), primitive_at(mesh, p), pose_.weights(node), accessors_,
                   place_of(mesh, p));
  }

  SourceRange source(int node, std::size_t p, int instance) const {
    SourceRange range;
    range.node = node;
    range.mesh = node_at(node).mesh;
    range.primitive = static_cast<std::int32_t>(p);
    range.instance = instance;
    return range;
  }

  FileNotes notes() const {
    FileNotes notes;
    notes.format = "glTF";
    notes.unit = "metre";
    for (const tinygltf::Scene& scene : model_.scenes) notes.scenes.push_back(scene.name);
    notes.scene = scene_;
    notes.animations = document_.animations;
    if (document_.animation) notes.animation = document_.animation->index;
    return notes;
  }

  const LoadOptions& options_;
  std::uint64_t bytes_;  ///< of the scene's own file
  GltfDocument document_;
  const tinygltf::Model& model_;
  GltfViews views_;
  AccessorReader accessors_;
  GltfDraco draco_;
  int scene_;
  std::vector<int> parents_;
  Pose pose_;
  std::vector<std::optional<std::vector<DecodedPrimitive>>>
      decoded_;                                             ///< by mesh; empty where no node needs it
  std::unordered_map<int, std::vector<Placement>> joints_;  ///< by skin
  GltfAssembly assembly_;
};

}  // namespace

SceneSource load_gltf(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options) {
  return {GltfLoader(file, folder, options).load(), std::nullopt};
}

}  // namespace provis
