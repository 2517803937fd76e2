#pragma once
// The bytes of a document's buffer views, decompressed where EXT_meshopt_compression holds them.

#include <string>
#include <unordered_map>

#include "src/scene/file_bytes.hpp"
#include "src/scene/gltf_buffers.hpp"
#include "src/scene/gltf_model.hpp"

namespace provis {

/// Compressed views are decoded when first asked for, and kept. Where there is compressed data it is what
/// counts: the buffer beside it may be a placeholder without data, and is never opened.
class GltfViews {
 public:
  /// Both must outlive this object.
  GltfViews(const tinygltf::Model& model, GltfBuffers& buffers) : model_(model), buffers_(buffers) {}

  struct View {
    ByteSpan bytes;
    std::size_t stride = 0;  ///< between elements; 0 where they are as long as they are apart
  };

  /// The bytes stay where they are.
  ///
  /// Throws:     Error::invalid_input naming view or extension: out of range, against the extension's rules,
  ///             broken data; whatever GltfBuffers::bytes throws
  View view(int index, const std::string& wanted_by);

  /// Adds bytes that are no view of the file. The result is an index from first_index_of_ours on.
  int add(Bytes bytes);

 private:
  ByteSpan part(int buffer, std::uint64_t offset, std::uint64_t length, const std::string& place);
  ByteSpan decoded(int index, const std::string& place);

  const tinygltf::Model& model_;
  GltfBuffers& buffers_;
  std::unordered_map<int, Bytes> kept_;  ///< by view: decoded or added
  int next_ = first_index_of_ours;
};

}  // namespace provis
