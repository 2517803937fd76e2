#pragma once
// The bytes of a document's buffers, loaded when first asked for.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "src/scene/file_bytes.hpp"
#include "src/scene/json_member.hpp"

namespace provis {

/// Buffers that no triangle needs (of images, of animations) are never looked for.
class GltfBuffers {
 public:
  /// folder: the scene file's; binary: the GLB's second chunk, which must outlive this object
  GltfBuffers(const Json& document, std::filesystem::path folder, std::optional<ByteSpan> binary);

  /// Exactly byteLength bytes.
  ///
  /// Throws:     Error::invalid_input: missing, too short, outside the folder, or without data, as
  ///             EXT_meshopt_compression leaves placeholders
  ByteSpan bytes(std::size_t buffer, const std::string& wanted_by);

  /// Of all buffers that were loaded so far, the GLB's second chunk left out.
  std::uint64_t loaded_bytes() const;

 private:
  struct Buffer {
    std::optional<std::string> uri;
    std::optional<std::uint64_t> length;
    std::optional<Bytes> loaded;
  };

  ByteSpan available(Buffer& buffer, std::size_t index, const std::string& place);

  std::filesystem::path folder_;
  std::optional<ByteSpan> binary_;
  std::vector<Buffer> buffers_;
};

}  // namespace provis
