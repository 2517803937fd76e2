#pragma once
// Numbers to and from little-endian bytes at any alignment.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace provis {

static_assert(std::endian::native == std::endian::little,
              "the loaders copy little-endian file content straight into numbers");

template <class T>
T from_little_endian(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

template <class T>
T from_big_endian(const std::uint8_t* bytes) {
  std::uint8_t reversed[sizeof(T)];
  for (std::size_t i = 0; i < sizeof(T); ++i) reversed[i] = bytes[sizeof(T) - 1 - i];
  return from_little_endian<T>(reversed);
}

}  // namespace provis
