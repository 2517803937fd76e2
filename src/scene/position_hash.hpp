#pragma once
// A hash of exact positions.

#include <bit>
#include <cstdint>

#include "provis/vec3.hpp"

namespace provis {

/// Equal for equal positions; +0 and -0 are equal.
inline std::uint64_t position_hash(const Vec3d& p) {
  const auto mixed = [](std::uint64_t h) {
    h ^= h >> 32;
    h *= 0xd6e8feb86659fd93u;
    return h ^ (h >> 32);
  };
  // Adding zero turns -0 into +0.
  const auto bits = [](double d) { return std::bit_cast<std::uint64_t>(d + 0.0); };
  return mixed(mixed(mixed(bits(p.x)) + bits(p.y)) + bits(p.z));
}

}  // namespace provis
