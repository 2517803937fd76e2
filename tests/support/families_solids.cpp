#include <cmath>

#include "tests/support/families.hpp"

namespace provis::test {

namespace {

void box_on_floor(MeshBuilder& mesh) {
  Random& random = mesh.random();
  mesh.parallelogram({-3, 0, 3}, {6, 0, 0}, {0, 0, -6});
  const double x = random.between(-2, 1), z = random.between(-2, 1);
  mesh.box({x, 0, z}, {x + 1, double(random.between(1, 2)), z + 1});
}

/// Boxes on top of and beside each other: faces in contact, edges in line, corners in common.
void stacked_boxes(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int count = random.between(2, 3);
  Vec3d lo = random.lattice(1);
  for (int i = 0; i < count; ++i) {
    const Vec3d size{double(random.between(1, 2)), double(random.between(1, 2)),
                     double(random.between(1, 2))};
    mesh.box(lo, lo + size);
    switch (random.between(0, 3)) {
      case 0:
        lo.x += size.x;
        break;
      case 1:
        lo.y += size.y;
        break;
      case 2:
        lo.z -= size.z;
        break;
      default:
        lo = lo + size;
    }
  }
}

void closed_mesh(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const double r = random.between(1, 3);
  const Vec3d center = random.lattice(1);
  const auto at = [&](double x, double y, double z) { return center + Vec3d{x * r, y * r, z * r}; };
  switch (random.between(0, 2)) {
    case 0: {
      const Vec3d a = at(1, 1, 1), b = at(1, -1, -1), c = at(-1, 1, -1), d = at(-1, -1, 1);
      mesh.triangle(a, b, c);
      mesh.triangle(a, c, d);
      mesh.triangle(a, d, b);
      mesh.triangle(b, d, c);
      break;
    }
    case 1:
      mesh.box(at(-1, -1, -1), at(1, 1, 1));
      break;
    default: {
      const Vec3d ring[4] = {at(1, 0, 0), at(0, 1, 0), at(-1, 0, 0), at(0, -1, 0)};
      for (int i = 0; i < 4; ++i) {
        mesh.triangle(ring[i], ring[(i + 1) % 4], at(0, 0, 1));
        mesh.triangle(ring[(i + 1) % 4], ring[i], at(0, 0, -1));
      }
    }
  }
}

/// One closed mesh in another, touching it or not.
void nested(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const double outer = random.between(2, 3), inner = random.pick({0.5, 1.0, 2.0});
  mesh.box({-outer, -outer, -outer}, {outer, outer, outer});
  const Vec3d at = random.chance(50) ? Vec3d{0, 0, 0} : random.lattice(1);
  mesh.box(at - Vec3d{inner, inner, inner}, at + Vec3d{inner, inner, inner});
}

void staircase(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int steps = random.between(2, 5);
  const double width = random.between(1, 3);
  for (int i = 0; i < steps; ++i) {
    const double y = i, z = -i;
    mesh.parallelogram({-width, y, z}, {2 * width, 0, 0}, {0, 1, 0});
    mesh.parallelogram({-width, y + 1, z}, {2 * width, 0, 0}, {0, 0, -1});
  }
}

/// Filled cells of a small grid. Whole boxes, so that faces between neighbours coincide; or the hull only.
void voxels(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int size = 2;
  bool filled[size + 2][size + 2][size + 2] = {};
  const int count = random.between(2, 4);
  for (int i = 0; i < count; ++i) {
    filled[random.between(1, size)][random.between(1, size)][random.between(1, size)] = true;
  }
  const bool hull_only = random.chance(60);
  for (int x = 1; x <= size; ++x) {
    for (int y = 1; y <= size; ++y) {
      for (int z = 1; z <= size; ++z) {
        if (!filled[x][y][z] || mesh.size() > 36) continue;
        const bool taken[6] = {filled[x - 1][y][z], filled[x + 1][y][z], filled[x][y - 1][z],
                               filled[x][y + 1][z], filled[x][y][z - 1], filled[x][y][z + 1]};
        unsigned faces = 0;
        for (unsigned f = 0; f < 6; ++f) faces |= (hull_only && taken[f]) ? 0u : 1u << f;
        const Vec3d lo{double(x - 2), double(y - 2), double(z - 2)};
        mesh.box(lo, lo + Vec3d{1, 1, 1}, faces);
      }
    }
  }
}

/// A wall with an opening, in four strips, before things that the opening frames exactly or nearly.
void wall_with_window(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const double w = random.pick({0.5, 1.0}), far = random.pick({2.0, 4.0});
  mesh.parallelogram({-2, -2, -1}, {4, 0, 0}, {0, 2 - w, 0});
  mesh.parallelogram({-2, w, -1}, {4, 0, 0}, {0, 2 - w, 0});
  mesh.parallelogram({-2, -w, -1}, {2 - w, 0, 0}, {0, 2 * w, 0});
  mesh.parallelogram({w, -w, -1}, {2 - w, 0, 0}, {0, 2 * w, 0});
  const double slip = random.pick({0.0, 0.0, 0x1p-50, -0x1p-50, 0.25});
  const double x = (w + slip) * far;  // seen from the origin, x/far is the opening's right border plus slip
  mesh.triangle({x, -1, -far}, {x + 1, -1, -far}, {x, 1, -far});
  mesh.parallelogram({-w * far, -w * far, -far - random.between(0, 1)}, {2 * w * far, 0, 0},
                     {0, 2 * w * far, 0});
}

/// Two half planes that meet, miss each other by an ulp or overlap by an ulp, before something to be hidden.
void gap(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const double at = random.pick({0.0, 0.5, 1.0});
  const int ulps = random.between(-1, 1);
  const double other = ulps == 0 ? at : std::nextafter(at, ulps * 10.0);
  const double shift = random.chance(30) ? 1 : 0;
  mesh.parallelogram({-3, -3, -1}, {at + 3, 0, 0}, {0, 6, 0});
  const double z = -1 - shift;
  const double left = other * (1 + shift);  // seen from the origin, a doubled distance doubles it
  mesh.quad({left, -6, z}, {6, -6, z}, {6, 6, z}, {left, 6, z});
  mesh.triangle({at * 4 - 1, -1, -4}, {at * 4 + 1, -1, -4}, {at * 4, 1, -4});
  if (random.chance(50)) mesh.parallelogram({-8, -8, -5}, {16, 0, 0}, {0, 16, 0});
}

void corridor(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int cells = random.between(1, 3);
  for (int i = 0; i < cells; ++i) {
    const double z = -2.0 * i;
    mesh.box({-1, -1, z - 2}, {1, 1, z}, random.chance(50) ? 15u : 47u);
    if (random.chance(60)) mesh.parallelogram({-1, -1, z - 2}, {1, 0, 0}, {0, 2, 0});
  }
}

}  // namespace

const std::vector<Family>& solid_families() {
  static const std::vector<Family> all = {
      {"box-on-floor", box_on_floor},
      {"stacked-boxes", stacked_boxes},
      {"closed-mesh", closed_mesh},
      {"nested", nested},
      {"staircase", staircase},
      {"voxels", voxels},
      {"wall-with-window", wall_with_window},
      {"gap", gap},
      {"corridor", corridor},
  };
  return all;
}

}  // namespace provis::test
