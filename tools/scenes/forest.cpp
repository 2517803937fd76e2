#include <array>
#include <cstdlib>

#include "tools/scenes/generators.hpp"
#include "tools/scenes/layout.hpp"

namespace provis::scenes {

namespace {

constexpr std::int32_t metre = 1 << 12;

/// A ring of eight corners around a point, across the axis that the tube follows most.
std::uint32_t add_ring(Mesh& mesh, const Point& center, std::int32_t radius, bool upright, bool along_x) {
  constexpr std::array<std::array<int, 2>, 8> octagon = {
      {{100, 0}, {71, 71}, {0, 100}, {-71, 71}, {-100, 0}, {-71, -71}, {0, -100}, {71, -71}}};
  std::uint32_t first = 0;
  for (std::size_t k = 0; k < octagon.size(); ++k) {
    const std::int32_t u = octagon[k][0] * radius / 100, v = octagon[k][1] * radius / 100;
    const Point offset = upright ? Point{u, 0, -v} : along_x ? Point{0, u, v} : Point{v, u, 0};
    const std::uint32_t index = mesh.vertex(center + offset);
    if (k == 0) first = index;
  }
  return first;
}

/// A tapered tube of eight sides from a to b, in two lengths, that ends in a point.
void add_tube(Mesh& mesh, const Point& a, const Point& b, std::int32_t radius) {
  const Point d = b - a;
  const bool upright = std::abs(d.y) >= std::abs(d.x) && std::abs(d.y) >= std::abs(d.z);
  const bool along_x = std::abs(d.x) >= std::abs(d.z);
  const Point middle{(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2};
  const std::uint32_t low = add_ring(mesh, a, radius, upright, along_x);
  const std::uint32_t high = add_ring(mesh, middle, radius * 2 / 3, upright, along_x);
  const std::uint32_t tip = mesh.vertex(b);
  for (std::uint32_t k = 0; k < 8; ++k) {
    const std::uint32_t next = (k + 1) % 8;
    mesh.quad(low + k, low + next, high + next, high + k);
    mesh.triangle(high + k, high + next, tip);
  }
}

/// A folded rhombus.
void add_leaf(Mesh& mesh, Random& random, const Point& stalk) {
  constexpr int size = metre / 4;
  const auto offset = [&](int most) {
    return Point{random.between(-most, most), random.between(-most, most), random.between(-most, most)};
  };
  const Point along = offset(size), across = offset(size / 2);
  const std::uint32_t first = mesh.vertex(stalk);
  mesh.vertex(stalk + Point{along.x / 2, along.y / 2, along.z / 2} + across);
  mesh.vertex(stalk + along);
  mesh.vertex(stalk + Point{along.x / 2, along.y / 2 + size / 5, along.z / 2} - across);
  mesh.quad(first, first + 1, first + 2, first + 3);
}

void add_tree(Mesh& mesh, Random& random, const Point& root) {
  constexpr int leaves = 48;
  const int height = random.between(5 * metre, 9 * metre), branches = random.between(16, 28);
  const Point top =
      root + Point{random.between(-metre / 2, metre / 2), height, random.between(-metre / 2, metre / 2)};
  add_tube(mesh, root - Point{0, metre / 4, 0}, top, height / 40);
  for (int b = 0; b < branches; ++b) {
    const int at = random.between(25, 95), reach = height * (105 - at) / 250 + metre / 4;
    const Point d = top - root;
    const Point start = root + Point{d.x / 100 * at, d.y / 100 * at, d.z / 100 * at};
    const Point branch{random.between(-reach, reach), random.between(0, reach / 2),
                       random.between(-reach, reach)};
    add_tube(mesh, start, start + branch, height / 160);
    for (int n = 0; n < leaves; ++n) {
      const int where = random.between(20, 100);
      const Point stray{random.between(-metre / 5, metre / 5), random.between(-metre / 5, metre / 5),
                        random.between(-metre / 5, metre / 5)};
      add_leaf(mesh, random,
               start + Point{branch.x / 100 * where, branch.y / 100 * where, branch.z / 100 * where} + stray);
    }
  }
}

}  // namespace

void forest(Mesh& mesh, std::uint64_t triangles) {
  constexpr std::int32_t pitch = 4 * metre;
  const Ground ground(17, 6 * metre);
  outward([&](int i, int k) {
    Random random = random_at(2, i, k);
    const std::int32_t x = i * pitch, z = k * pitch;
    add_ground(mesh, ground, x, z, pitch / 8, 8);
    const std::int32_t at_x = x + random.between(metre, pitch - metre),
                       at_z = z + random.between(metre, pitch - metre);
    add_tree(mesh, random, ground.at(at_x, at_z));
    return mesh.triangles() < triangles;
  });
}

}  // namespace provis::scenes
