#include "tools/scenes/generators.hpp"
#include "tools/scenes/layout.hpp"

namespace provis::scenes {

namespace {

constexpr std::int32_t metre = 1 << 13;

/// Two bent quads and a tip.
void add_blade(Mesh& mesh, Random& random, const Point& root) {
  const int height = random.between(metre / 5, metre / 2);
  const Point half{random.between(-50, 50), 0, random.between(-50, 50)};
  const Point lean{random.between(-metre / 5, metre / 5), height, random.between(-metre / 5, metre / 5)};
  const auto along = [&](int side, int sideways, int upwards, int width) {
    return root + Point{lean.x * sideways / 100 + side * half.x * width / 100, height * upwards / 100,
                        lean.z * sideways / 100 + side * half.z * width / 100};
  };
  const std::uint32_t first = mesh.vertex(along(-1, 0, 0, 100));
  mesh.vertex(along(1, 0, 0, 100));
  mesh.vertex(along(-1, 15, 40, 80));
  mesh.vertex(along(1, 15, 40, 80));
  mesh.vertex(along(-1, 50, 75, 50));
  mesh.vertex(along(1, 50, 75, 50));
  mesh.vertex(root + lean);
  mesh.quad(first, first + 1, first + 3, first + 2);
  mesh.quad(first + 2, first + 3, first + 5, first + 4);
  mesh.triangle(first + 4, first + 5, first + 6);
}

void meadow(Mesh& mesh, std::uint64_t triangles, int blades_per_square_metre) {
  const Ground ground(17, 2 * metre);
  outward([&](int i, int k) {
    Random random = random_at(1, i, k);
    const std::int32_t x = i * metre, z = k * metre;
    add_ground(mesh, ground, x, z, metre / 4, 4);
    for (int n = 0; n < blades_per_square_metre; ++n) {
      const std::int32_t at_x = x + random.between(0, metre - 1), at_z = z + random.between(0, metre - 1);
      add_blade(mesh, random, ground.at(at_x, at_z) - Point{0, metre / 50, 0});
    }
    return mesh.triangles() < triangles;
  });
}

}  // namespace

void grass(Mesh& mesh, std::uint64_t triangles) { meadow(mesh, triangles, 100); }

void dense_grass(Mesh& mesh, std::uint64_t triangles) { meadow(mesh, triangles, 1000); }

}  // namespace provis::scenes
