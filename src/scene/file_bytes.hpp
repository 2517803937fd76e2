#pragma once
// A whole file in memory.

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace provis {

using Bytes = std::vector<std::uint8_t>;
using ByteSpan = std::span<const std::uint8_t>;

/// The content of a regular file.
///
/// Throws:     Error::invalid_input with an empty place and the system's reason; for anything that is no
///             regular file too, since a device or a pipe has no size that could bound the memory
Bytes read_file(const std::filesystem::path& file);

}  // namespace provis
