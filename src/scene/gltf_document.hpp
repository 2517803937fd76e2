#pragma once
// A glTF file, binary or text, taken apart into a typed model and its buffers.

#include <filesystem>
#include <optional>

#include "src/scene/asked_animation.hpp"
#include "src/scene/file_bytes.hpp"
#include "src/scene/gltf_buffers.hpp"
#include "src/scene/gltf_model.hpp"

namespace provis {

struct GltfDocument {
  tinygltf::Model model;  ///< of the reduced document (gltf_reduce.hpp)
  GltfBuffers buffers;
  std::optional<AskedAnimation> animation;  ///< where a time is asked for
  std::vector<AnimationInfo> animations;    ///< that the file offers
};

/// file: the content, which must outlive the result; folder: where its URIs point
///
/// Throws:     Error::invalid_input with a byte offset for broken JSON, otherwise naming the member;
///             Error::unsupported naming a version or required extension; whatever asked_animation throws
GltfDocument read_gltf(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options);

}  // namespace provis
