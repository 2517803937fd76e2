#pragma once
// SHA-256 over the exact content of a scene (semantics.md, "Hash").

#include <string>

#include "provis/scene.hpp"
#include "src/scene/file_bytes.hpp"

namespace provis {

/// 64 lower-case hexadecimal digits.
///
/// Cost:       O(V + F + S), streamed: no copy of the arrays
std::string scene_hash(const SceneArrays& arrays);

/// The same of the bytes of a file.
std::string bytes_hash(ByteSpan bytes);

}  // namespace provis
