#include "tools/scenes/generators.hpp"
#include "tools/scenes/layout.hpp"

namespace provis::scenes {

void soup(Mesh& mesh, std::uint64_t triangles) {
  constexpr int half = 1 << 20;
  // Twice as long as the cube's side divided among the triangles, so that neighbours cross.
  int size = half;
  while (static_cast<std::uint64_t>(half / size) * (half / size) * (half / size) * 8 < triangles)
    size -= size / 64;
  for (std::uint64_t t = 0; t < triangles; ++t) {
    Random random = random_at(4, static_cast<std::int64_t>(t), 0);
    const auto offset = [&](int most) {
      return Point{random.between(-most, most), random.between(-most, most), random.between(-most, most)};
    };
    const Point center = offset(half);
    const std::uint32_t first = mesh.vertex(center + offset(size));
    mesh.vertex(center + offset(size));
    mesh.vertex(center + offset(size));
    mesh.triangle(first, first + 1, first + 2);
  }
}

}  // namespace provis::scenes
