#pragma once
// EXT_meshopt_compression: the codecs and filters of libmeshoptimizer, and the extension's rules.

#include <cstdint>
#include <string>

#include "src/scene/file_bytes.hpp"

namespace provis {

/// What the extension says of one buffer view.
struct MeshoptLayout {
  std::string mode;    ///< ATTRIBUTES, TRIANGLES or INDICES
  std::string filter;  ///< NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL
  std::uint64_t count = 0, stride = 0;
};

/// Throws Error::invalid_input naming the rule: an unknown mode or filter, or a stride, count or filter that
/// the mode does not allow. Without it, count * stride may overflow.
void check_layout(const MeshoptLayout& layout, const std::string& place);

/// The count * stride bytes of a layout that was checked.
///
/// Throws:     Error::invalid_input where the data is broken; before memory is taken where it is too short
///             for that many elements: the result is never longer than 64 times the compressed bytes
/// Source:     the extension's appendices A and B (Khronos)
Bytes decode_meshopt(ByteSpan compressed, const MeshoptLayout& layout, const std::string& place);

}  // namespace provis
