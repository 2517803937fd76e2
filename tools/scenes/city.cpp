#include <array>

#include "tools/scenes/generators.hpp"
#include "tools/scenes/layout.hpp"

namespace provis::scenes {

namespace {

constexpr std::int32_t metre = 1 << 10;
constexpr std::int32_t lot = 15 * metre, street = 14 * metre, lots_x = 4, lots_z = 3;
constexpr std::int32_t curb = metre / 8;

/// An upright wall: its lower left corner seen from outside, a step of one unit to the right, one outwards.
struct Wall {
  Point corner, right, out;

  Point at(std::int32_t along, std::int32_t up, std::int32_t outwards) const {
    return corner + Point{right.x * along + out.x * outwards, up, right.z * along + out.z * outwards};
  }
};

/// A rectangle of a wall, at some distance in front of it.
struct Panel {
  std::int32_t x0, x1, y0, y1, out;
};

std::uint32_t add_corners(Mesh& mesh, const Wall& wall, const Panel& p) {
  const std::uint32_t first = mesh.vertex(wall.at(p.x0, p.y0, p.out));
  mesh.vertex(wall.at(p.x1, p.y0, p.out));
  mesh.vertex(wall.at(p.x1, p.y1, p.out));
  mesh.vertex(wall.at(p.x0, p.y1, p.out));
  return first;
}

/// The four quads between two panels whose corners were added.
void add_rim(Mesh& mesh, std::uint32_t outer, std::uint32_t inner) {
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t next = (k + 1) % 4;
    mesh.quad(outer + k, outer + next, inner + next, inner + k);
  }
}

/// A panel of wall around a recessed window.
void add_window(Mesh& mesh, const Wall& wall, const Panel& bay) {
  const std::int32_t w = (bay.x1 - bay.x0) / 5, h = (bay.y1 - bay.y0) / 4;
  const Panel frame{bay.x0 + w, bay.x1 - w, bay.y0 + h, bay.y1 - h / 2, 0};
  Panel pane = frame;
  pane.out = -metre / 5;
  const std::uint32_t outer = add_corners(mesh, wall, bay), rim = add_corners(mesh, wall, frame),
                      inner = add_corners(mesh, wall, pane);
  add_rim(mesh, outer, rim);
  add_rim(mesh, rim, inner);
  mesh.quad(inner, inner + 1, inner + 2, inner + 3);
}

/// Something that stands out of a wall: without a back.
void add_ledge(Mesh& mesh, const Wall& wall, const Panel& front) {
  Panel back = front;
  back.out = 0;
  const std::uint32_t outer = add_corners(mesh, wall, back), inner = add_corners(mesh, wall, front);
  add_rim(mesh, outer, inner);
  mesh.quad(inner, inner + 1, inner + 2, inner + 3);
}

struct Extent {
  std::int32_t x0, x1, z0, z1;
};

std::array<Wall, 4> walls(const Extent& e, std::int32_t y) {
  return {{{{e.x0, y, e.z1}, {1, 0, 0}, {0, 0, 1}},
           {{e.x1, y, e.z1}, {0, 0, -1}, {1, 0, 0}},
           {{e.x1, y, e.z0}, {-1, 0, 0}, {0, 0, -1}},
           {{e.x0, y, e.z0}, {0, 0, 1}, {-1, 0, 0}}}};
}

void add_floor(Mesh& mesh, const Extent& e, std::int32_t y) {
  const std::uint32_t first = mesh.vertex({e.x0, y, e.z1});
  mesh.vertex({e.x1, y, e.z1});
  mesh.vertex({e.x1, y, e.z0});
  mesh.vertex({e.x0, y, e.z0});
  mesh.quad(first, first + 1, first + 2, first + 3);
}

/// Upright sides and a top: what stands on something needs no bottom.
void add_block(Mesh& mesh, const Extent& e, std::int32_t y0, std::int32_t y1) {
  for (const Wall& wall : walls(e, y0)) {
    const std::int32_t length = wall.right.x != 0 ? e.x1 - e.x0 : e.z1 - e.z0;
    const std::uint32_t first = add_corners(mesh, wall, {0, length, 0, y1 - y0, 0});
    mesh.quad(first, first + 1, first + 2, first + 3);
  }
  add_floor(mesh, e, y1);
}

void add_building(Mesh& mesh, Random& random, std::int32_t x, std::int32_t z) {
  // Whole lots share a party wall with their neighbours.
  const std::int32_t inset = random.pick<std::int32_t>({0, 0, 480, 960});
  const std::int32_t size = lot - 2 * inset, bays = random.pick<std::int32_t>({4, 5, 6, 8}),
                     bay = size / bays;
  const std::int32_t floors = random.chance(15) ? random.between(12, 30) : random.between(3, 9);
  const std::int32_t storey = random.pick<std::int32_t>({3 * metre, 3 * metre + metre / 4, 4 * metre});
  const Extent e{x + inset, x + inset + size, z + inset, z + inset + size};
  for (const Wall& wall : walls(e, curb))
    for (std::int32_t f = 0; f < floors; ++f) {
      for (std::int32_t b = 0; b < bays; ++b)
        add_window(mesh, wall, {b * bay, (b + 1) * bay, f * storey, (f + 1) * storey, 0});
      add_ledge(mesh, wall, {0, size, (f + 1) * storey - metre / 4, (f + 1) * storey, metre / 8});
    }
  const std::int32_t roof = curb + floors * storey, wide = metre / 4, high = roof + metre;
  add_floor(mesh, e, roof);
  for (const Extent& parapet : {Extent{e.x0, e.x1, e.z0, e.z0 + wide}, Extent{e.x0, e.x1, e.z1 - wide, e.z1},
                                Extent{e.x0, e.x0 + wide, e.z0, e.z1}, Extent{e.x1 - wide, e.x1, e.z0, e.z1}})
    add_block(mesh, parapet, roof, high);
  add_block(mesh, {e.x0 + size / 4, e.x0 + size / 2, e.z0 + size / 4, e.z0 + size / 2}, roof,
            roof + 3 * metre);
}

}  // namespace

void city(Mesh& mesh, std::uint64_t triangles) {
  constexpr std::int32_t pitch_x = lots_x * lot + street, pitch_z = lots_z * lot + street;
  outward([&](int i, int k) {
    Random random = random_at(3, i, k);
    const std::int32_t x = i * pitch_x + street / 2, z = k * pitch_z + street / 2;
    add_floor(mesh, {i * pitch_x, (i + 1) * pitch_x, k * pitch_z, (k + 1) * pitch_z}, 0);
    const std::int32_t walk = 2 * metre;
    add_block(mesh, {x - walk, x + lots_x * lot + walk, z - walk, z + lots_z * lot + walk}, 0, curb);
    for (std::int32_t a = 0; a < lots_x; ++a)
      for (std::int32_t b = 0; b < lots_z && mesh.triangles() < triangles; ++b)
        add_building(mesh, random, x + a * lot, z + b * lot);
    return mesh.triangles() < triangles;
  });
}

}  // namespace provis::scenes
