#pragma once
// Random numbers that are the same on every machine, unlike the distributions of the standard library.

#include <cstdint>
#include <initializer_list>
#include <utility>

#include "provis/vec3.hpp"

namespace provis::test {

/// Steele, Lea, Flood: Fast splittable pseudorandom number generators, 2014 (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// 0 .. n-1; n is small, so the bias of the remainder does not matter to a test.
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(next() % n); }

  /// lo .. hi, both included.
  int between(int lo, int hi) { return lo + static_cast<int>(below(static_cast<std::size_t>(hi - lo + 1))); }

  bool chance(int percent) { return between(0, 99) < percent; }

  /// [0, 1)
  double unit() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// A lattice point of the cube [-size, size]^3.
  Vec3d lattice(int size) {
    const int x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {double(x), double(y), double(z)};
  }

  template <class T>
  T pick(std::initializer_list<T> choices) {
    return choices.begin()[below(choices.size())];
  }

  template <class Container>
  const auto& pick_from(const Container& choices) {
    return choices[below(choices.size())];
  }

  template <class Container>
  void shuffle(Container& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::uint64_t state_;
};

}  // namespace provis::test
