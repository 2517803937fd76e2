#pragma once
// KHR_draco_mesh_compression: primitives whose data is a Draco mesh become primitives over accessors.

#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "src/scene/accessor.hpp"
#include "src/scene/draco.hpp"

namespace provis {

/// Hands the decoded data to accessors that are copies of the primitive's own (AccessorReader::supply), so
/// that everything behind reads it like any other, and an accessor that several primitives name with
/// different data is a different one for each.
class GltfDraco {
 public:
  /// Both must outlive this object.
  GltfDraco(GltfViews& views, AccessorReader& accessors) : views_(views), accessors_(accessors) {}

  /// Replaces the accessors of a primitive that is compressed, and its mode: Draco knows triangles only.
  /// Where every accessor that the extension stands for has a buffer view of its own, that is read instead:
  /// it has not been rounded.
  ///
  /// Throws:     Error::invalid_input naming primitive or accessor: a mode or an accessor that does not match
  ///             the compressed data, and whatever DracoMesh throws
  void decompress(tinygltf::Primitive& primitive, const std::string& place);

 private:
  bool has_plain_data(const tinygltf::Primitive& primitive, const std::string& place) const;
  const DracoMesh& mesh(int view, const std::string& place);
  int supplied_attribute(int accessor, int view, std::uint64_t id, const std::string& place);
  int supplied_indices(int accessor, int view, bool count_is_free, const std::string& place);
  int supply(int accessor, const std::vector<double>& numbers, std::size_t components,
             const std::string& place);

  GltfViews& views_;
  AccessorReader& accessors_;
  DracoBudget budget_;
  std::map<int, DracoMesh> meshes_;  ///< by buffer view

  /// By accessor, buffer view, and attribute or no_attribute for the indices.
  std::map<std::tuple<int, int, std::uint64_t>, int> supplied_;
};

}  // namespace provis
