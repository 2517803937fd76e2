#pragma once
// Random numbers that are the same on every machine.

#include <cstdint>

namespace provis {

/// Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014 (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// One of many for the same seed.
  Random(std::uint64_t seed, std::uint64_t stream) : state_(seed * 0x100000001b3u + stream) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// [0, 1)
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// [-1, 1)
  double signed_unit() { return static_cast<double>(next() >> 11) * 0x1p-52 - 1; }

 private:
  std::uint64_t state_;
};

}  // namespace provis
