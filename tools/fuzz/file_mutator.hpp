#pragma once
// Mutations that keep JSON JSON and a GLB a GLB, so that a fuzzer gets past parser and container.

#include <cstdint>
#include <random>
#include <vector>

namespace provis::fuzz {

using Bytes = std::vector<std::uint8_t>;
using Random = std::minstd_rand;

/// A .gltf or result: changes members. A .glb: changes its JSON or its binary chunk, and repairs the lengths
/// around them. Now and then, and for everything else, changes bytes by the fuzzer's own means.
///
/// most: bytes; the result may be longer, and is then cut
Bytes mutated_file(const Bytes& file, std::size_t most, Random& random);

}  // namespace provis::fuzz
