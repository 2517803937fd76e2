#include <cmath>

#include "tools/scenes/generators.hpp"
#include "tools/scenes/layout.hpp"

namespace provis::scenes {

namespace {

/// Trilinear noise in [0, 1) over the integer lattice. Sums and products only, each correctly rounded.
double noise(double x, double y, double z) {
  const double i = std::floor(x), j = std::floor(y), k = std::floor(z);
  const auto value = [&](int di, int dj, int dk) {
    const auto layer = static_cast<std::uint64_t>(static_cast<std::int64_t>(k) + dk + 1000);
    return random_at(layer, static_cast<std::int64_t>(i) + di, static_cast<std::int64_t>(j) + dj).unit();
  };
  const auto mix = [](double a, double b, double t) { return a + (b - a) * (t * t * (3 - 2 * t)); };
  const auto row = [&](int dj, int dk) { return mix(value(0, dj, dk), value(1, dj, dk), x - i); };
  return mix(mix(row(0, 0), row(1, 0), y - j), mix(row(0, 1), row(1, 1), y - j), z - k);
}

/// The sphere's point in the direction of a point of the octahedron |x| + |y| + |z| = n. A square root is
/// correctly rounded like a sum.
Point bumpy(double x, double y, double z) {
  const double length = std::sqrt(x * x + y * y + z * z);
  x /= length, y /= length, z /= length;
  const double bumps = 0.5 * noise(4 * x, 4 * y, 4 * z) + 0.25 * noise(16 * x, 16 * y, 16 * z) +
                       0.03125 * noise(128 * x, 128 * y, 128 * z);
  const double radius = (8 + 8 * bumps) / closed_mesh_unit;
  const auto grid = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
  return {grid(radius * x), grid(radius * y), grid(radius * z)};
}

/// Rings of 4 r corners around the y axis, r from 0 up to n and back.
class Octahedron {
 public:
  explicit Octahedron(std::int64_t n) : n_(n) {}

  void add_to(Mesh& mesh) const {
    for (std::int64_t y = n_; y >= -n_; --y)
      for (std::int64_t s = 0; s < std::max<std::int64_t>(1, 4 * radius(y)); ++s) add_corner(mesh, y, s);
    for (std::int64_t y = n_; y > 0; --y) add_band(mesh, y, y - 1, false);
    for (std::int64_t y = -n_; y < 0; ++y) add_band(mesh, y, y + 1, true);
  }

 private:
  std::int64_t radius(std::int64_t y) const { return n_ - std::abs(y); }

  void add_corner(Mesh& mesh, std::int64_t y, std::int64_t s) const {
    const std::int64_t r = radius(y), q = r == 0 ? 0 : s / r, t = r == 0 ? 0 : s % r;
    const std::int64_t x[4] = {r - t, -t, t - r, t}, z[4] = {-t, t - r, t, r - t};
    mesh.vertex(bumpy(static_cast<double>(x[q]), static_cast<double>(y), static_cast<double>(z[q])));
  }

  std::uint32_t index(std::int64_t y, std::int64_t s) const {
    const std::int64_t r = radius(y), around = r == 0 ? 0 : s % (4 * r);
    // 1 + 4 (1 + ... + (r - 1)) corners come before ring r on the way down to the equator.
    const std::int64_t before = r == 0 ? 0 : 1 + 2 * r * (r - 1), all = 2 + 4 * n_ * n_;
    if (y >= 0) return static_cast<std::uint32_t>(before + around);
    return static_cast<std::uint32_t>(all - before - std::max<std::int64_t>(1, 4 * r) + around);
  }

  /// Between a ring and the next larger one; seen from outside either way.
  void add_band(Mesh& mesh, std::int64_t small, std::int64_t large, bool below) const {
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      below ? mesh.triangle(a, c, b) : mesh.triangle(a, b, c);
    };
    const std::int64_t r = radius(small);
    for (std::int64_t q = 0; q < 4; ++q)
      for (std::int64_t t = 0; t <= r; ++t) {
        const std::int64_t inner = q * r + t, outer = q * (r + 1) + t;
        add(index(small, inner), index(large, outer), index(large, outer + 1));
        if (t < r) add(index(small, inner), index(large, outer + 1), index(small, inner + 1));
      }
  }

  std::int64_t n_;
};

}  // namespace

void closed_mesh(Mesh& mesh, std::uint64_t triangles) {
  std::int64_t n = 1;
  while (8 * static_cast<std::uint64_t>(n * n) < triangles) ++n;
  Octahedron(n).add_to(mesh);
}

}  // namespace provis::scenes
