#include "tests/support/generator.hpp"

#include "tests/support/families.hpp"
#include "tests/support/knobs.hpp"
#include "tests/support/random.hpp"
#include "tests/support/triangles.hpp"
#include "tests/support/views.hpp"

namespace provis::test {

namespace {

const Family& any_family(Random& random) {
  return random.pick_from(random.chance(50) ? triangle_families() : solid_families());
}

}  // namespace

void build_scene(Case& c, Random& random) {
  MeshBuilder mesh(random, random.chance(60));
  const int wanted = random.pick({1, 1, 2, 3});
  for (int i = 0; i < wanted && mesh.size() < 24; ++i) {
    const Family& family = any_family(random);
    if (i > 0) c.name += '+';
    c.name += family.name;
    family.build(mesh);
  }
  if (!mesh.arrays().vertices.empty())
    c.name += mesh.arrays().vertices.size() == 3 * mesh.size() ? " split" : "";
  c.arrays = mesh.arrays();
}

Case generate(std::uint64_t seed) {
  Case c;
  c.seed = seed;
  Random random(seed);
  build_scene(c, random);
  disturb_scene(c, random);
  choose_view(c, random);
  move_case(c, random);
  return c;
}

Case random_soup(std::uint64_t seed, int n) {
  Case c;
  c.seed = seed;
  c.name = "soup of " + std::to_string(n);
  Random random(seed);
  const auto point = [&](double size) {
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return Vec3d{size * (2 * x - 1), size * (2 * y - 1), size * (2 * z - 1)};
  };
  for (int i = 0; i < n; ++i) {
    const Vec3d center = point(2);
    const Vec3d p = center + point(1), q = center + point(1), r = center + point(1);
    add_triangle(c.arrays, p, q, r);
  }
  c.view.eye = random.chance(50) ? Vec3d{0, 0, 6} : point(1);
  c.view.frames = {Frame{}};
  return c;
}

}  // namespace provis::test
