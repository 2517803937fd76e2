#pragma once
// The two chunks of a binary glTF file.

#include <optional>
#include <string_view>

#include "src/scene/file_bytes.hpp"

namespace provis {

struct GlbChunks {
  std::string_view json;
  std::optional<ByteSpan> binary;
};

bool is_glb(ByteSpan file);

/// Views into the file; nothing is copied.
///
/// Degenerate: bytes after the declared length and chunks of unknown type are ignored, as glTF demands
/// Throws:     Error::invalid_input naming the byte offset, Error::unsupported for another version
GlbChunks split_glb(ByteSpan file);

}  // namespace provis
