#pragma once
// What a format's reader hands to load_scene.

#include <filesystem>
#include <optional>
#include <string>

#include "provis/scene.hpp"
#include "src/scene/file_bytes.hpp"

namespace provis {

struct SceneSource {
  SceneArrays arrays;               ///< flags as the file has them, before --sides and --opacity
  std::optional<std::string> hash;  ///< that the file claims to have
};

/// Tells the format by the file's first bytes.
///
/// Throws:     Error::invalid_input for neither format; whatever the format's reader throws
SceneSource load_source(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options);

/// glTF 2.0, binary or text; folder: where its URIs point.
SceneSource load_gltf(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options);

/// PLY, ASCII or binary.
SceneSource load_ply(ByteSpan file, const LoadOptions& options);

}  // namespace provis
