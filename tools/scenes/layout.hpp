#pragma once
// Where things stand: cells around the origin, their random numbers, and the ground under them.

#include <cstdint>

#include "tests/support/random.hpp"
#include "tools/scenes/ply_mesh.hpp"

namespace provis::scenes {

using test::Random;

/// Random numbers of one place, whatever was drawn elsewhere.
inline Random random_at(std::uint64_t kind, std::int64_t i, std::int64_t k) {
  Random mixed((kind << 56) ^ (static_cast<std::uint64_t>(i) << 28) ^ static_cast<std::uint64_t>(k));
  return Random(mixed.next());
}

/// Calls cell(i, k) in growing squares around the corner between the cells 0 and -1, until it returns false.
template <class Cell>
void outward(const Cell& cell) {
  for (int r = 1;; ++r)
    for (int i = -r; i < r; ++i) {
      const int step = i == -r || i == r - 1 ? 1 : 2 * r - 1;
      for (int k = -r; k < r; k += step)
        if (!cell(i, k)) return;
    }
}

/// Rolling ground: heights at lattice points, bilinear between them, in two sizes.
class Ground {
 public:
  /// Lattices of 2^shift and 2^(shift - 2) steps; heights up to the relief and a quarter of it.
  Ground(int shift, std::int32_t relief) : shift_(shift), relief_(relief) {}

  Point at(std::int32_t x, std::int32_t z) const {
    return {x, octave(x, z, shift_, relief_) + octave(x, z, shift_ - 2, relief_ / 4), z};
  }

 private:
  static std::int32_t octave(std::int32_t x, std::int32_t z, int shift, std::int32_t relief) {
    const std::int32_t i = x >> shift, k = z >> shift;
    const std::int64_t size = std::int64_t{1} << shift, fx = x - i * size, fz = z - k * size;
    const auto height = [&](std::int32_t di, std::int32_t dk) -> std::int64_t {
      return random_at(static_cast<std::uint64_t>(shift), i + di, k + dk).between(0, relief);
    };
    const std::int64_t near = height(0, 0) * (size - fx) + height(1, 0) * fx;
    const std::int64_t far = height(0, 1) * (size - fx) + height(1, 1) * fx;
    return static_cast<std::int32_t>((near * (size - fz) + far * fz) >> (2 * shift));
  }

  int shift_;
  std::int32_t relief_;
};

/// A square of ground, n by n quads of the given width with shared vertices, from its lowest corner on.
inline void add_ground(Mesh& mesh, const Ground& ground, std::int32_t x, std::int32_t z, std::int32_t width,
                       std::uint32_t n) {
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i <= n; ++i)
    for (std::uint32_t k = 0; k <= n; ++k) {
      const std::uint32_t v = mesh.vertex(
          ground.at(x + static_cast<std::int32_t>(i) * width, z + static_cast<std::int32_t>(k) * width));
      if (i == 0 && k == 0) first = v;
    }
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t v = first + i * (n + 1) + k;
      mesh.quad(v, v + 1, v + n + 2, v + n + 1);
    }
}

}  // namespace provis::scenes
