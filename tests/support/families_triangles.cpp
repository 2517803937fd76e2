#include <cmath>

#include "tests/support/families.hpp"

namespace provis::test {

namespace {

void lattice_triangles(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int size = random.between(1, 3), count = random.between(3, 16);
  for (int i = 0; i < count; ++i) {
    const Vec3d a = random.lattice(size), b = random.lattice(size), c = random.lattice(size);
    mesh.triangle(a, b, c);
  }
}

void coincident(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int count = random.between(1, 4);
  for (int i = 0; i < count; ++i) {
    Vec3d corner[3] = {random.lattice(2), random.lattice(2), random.lattice(2)};
    const int copies = random.between(2, 3);
    for (int copy = 0; copy < copies; ++copy) {
      if (random.chance(50)) std::swap(corner[0], corner[1]);
      mesh.triangle(corner[0], corner[1], corner[2]);
    }
  }
}

/// Triangles in one or two planes, overlapping each other in every way that small integers allow.
void coplanar(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int planes = random.between(1, 2);
  for (int p = 0; p < planes; ++p) {
    const Vec3d origin = random.lattice(2), u = random.lattice(2), v = random.lattice(2);
    const auto point = [&] {
      const double s = random.between(-2, 2), t = random.between(-2, 2);
      return origin + s * u + t * v;
    };
    const int count = random.between(2, 7);
    for (int i = 0; i < count; ++i) {
      const Vec3d a = point(), b = point(), c = point();
      mesh.triangle(a, b, c);
    }
  }
}

/// A large triangle with two or more small ones along its edge, before a backdrop.
void t_junctions(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const double z = random.between(-2, 1);
  const int parts = random.between(2, 4);
  const Vec3d left{-2, 0, z}, top{0, 2, z}, bottom{0, -2, z};
  const Vec3d step{4.0 / (1 << (parts - 1)), 0, 0};
  mesh.triangle(left, {2, 0, z}, top);
  Vec3d at = left;
  for (int i = 0; i + 1 < (1 << (parts - 1)); ++i) {
    mesh.triangle(bottom, at + step, at);
    at = at + step;
  }
  mesh.triangle(bottom, {2, 0, z}, at);
  mesh.parallelogram({-2, -2, z - 1}, {4, 0, 0}, {0, 4, 0});
}

void fan(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const Vec3d hub = random.lattice(1);
  const int count = random.between(3, 12);
  const bool closed = random.chance(60), flat = random.chance(40);
  std::vector<Vec3d> rim;
  for (int i = 0; i < count; ++i) {
    const double turn = 6.283185307179586 * i / count;
    const double height = flat ? 0 : random.between(-1, 1);
    rim.push_back(hub + Vec3d{std::rint(4 * std::cos(turn)) / 2, std::rint(4 * std::sin(turn)) / 2, height});
  }
  for (std::size_t i = 0; i + 1 < rim.size(); ++i) mesh.triangle(hub, rim[i], rim[i + 1]);
  if (closed) mesh.triangle(hub, rim.back(), rim.front());
  if (random.chance(50)) mesh.parallelogram({-2, -2, hub.z - 1}, {4, 0, 0}, {0, 4, 0});
}

/// Slivers and needles: one corner an ulp or a little off the line through the others, or on it.
void slivers(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int count = random.between(2, 6);
  for (int i = 0; i < count; ++i) {
    const Vec3d a = random.lattice(2), b = random.lattice(2);
    const double along = random.pick({0.0, 0.25, 0.5, 1.0});
    Vec3d c = a + along * (b - a);
    const double off = random.pick({0.0, 0x1p-52, 0x1p-30, 0x1p-10});
    c.x += off;
    c.y += random.chance(50) ? off : 0;
    mesh.triangle(a, b, c);
  }
  mesh.parallelogram({-2, -2, -3}, {4, 0, 0}, {0, 4, 0});
}

void interpenetrating(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int count = random.between(2, 5);
  const Vec3d center = random.lattice(1);
  for (int i = 0; i < count; ++i) {
    const Vec3d u = random.lattice(2), v = random.lattice(2);
    mesh.quad(center - u - v, center + u - v, center + u + v, center - u + v);
  }
}

/// Bars around an axis, each over its successor: no order front to back exists.
void cyclic_overlap(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int count = random.pick({3, 4, 5, 6});
  std::vector<Vec3d> ring;
  for (int i = 0; i < count; ++i) {
    const double turn = 6.283185307179586 * i / count;
    ring.push_back({std::rint(8 * std::cos(turn)) / 4, std::rint(8 * std::sin(turn)) / 4, 0});
  }
  const double lift = random.pick({0.25, 0.5, 1.0});
  for (int i = 0; i < count; ++i) {
    const Vec3d& from = ring[static_cast<std::size_t>(i)];
    const Vec3d& to = ring[static_cast<std::size_t>((i + 1) % count)];
    const Vec3d ahead = to - from, high{0, 0, lift};
    const Vec3d start = from - 0.5 * ahead + high, end = to + 0.5 * ahead - high;
    const Vec3d width = 0.25 * Vec3d{-ahead.y, ahead.x, 0};
    if (random.chance(50)) {
      mesh.triangle(start, end, start + width);
    } else {
      mesh.quad(start, end, end + width, start + width);
    }
  }
}

/// Triangles around the origin, some through it, where the eye often is.
void around_origin(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int count = random.between(2, 8);
  for (int i = 0; i < count; ++i) {
    const Vec3d a = random.lattice(3), b = random.lattice(3);
    const Vec3d c = random.chance(40) ? -(a + b) : random.lattice(3);
    mesh.triangle(a, b, c);
  }
}

/// Layers of parallel polygons whose silhouettes project onto each other exactly from the origin.
void aligned_layers(MeshBuilder& mesh) {
  Random& random = mesh.random();
  const int layers = random.between(2, 4);
  const Vec3d a{-1, -1, -1}, b{double(random.between(1, 2)), -1, -1}, c{double(random.between(-1, 1)), 1, -1};
  for (int i = 0; i < layers; ++i) {
    const double far = 1 << i;
    const double inner = random.pick({1.0, 1.0, 0.5});
    mesh.triangle(far * (inner * a), far * (inner * b), far * (inner * c));
    if (random.chance(40)) mesh.triangle(far * a, far * (0.5 * (b + c)), far * c);
  }
}

}  // namespace

const std::vector<Family>& triangle_families() {
  static const std::vector<Family> all = {
      {"lattice", lattice_triangles},
      {"coincident", coincident},
      {"coplanar", coplanar},
      {"t-junctions", t_junctions},
      {"fan", fan},
      {"slivers", slivers},
      {"interpenetrating", interpenetrating},
      {"cyclic", cyclic_overlap},
      {"around-origin", around_origin},
      {"aligned-layers", aligned_layers},
  };
  return all;
}

}  // namespace provis::test
