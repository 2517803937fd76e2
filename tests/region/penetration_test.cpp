// Triangles that pierce each other: what exact samples prove visible is never called hidden.

#include <catch2/catch.hpp>

#include "provis/cell.hpp"
#include "tests/support/cells.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

/// Positive where d is on the inner side of the triangle a b c; exact for small whole numbers.
double volume(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3d& d) {
  return dot(cross(b - a, c - a), d - a);
}

struct Corners {
  Vec3d a, b, c;
};

Corners corners(const SceneArrays& s, std::size_t t) {
  return {s.vertices[s.triangles[t][0]], s.vertices[s.triangles[t][1]], s.vertices[s.triangles[t][2]]};
}

/// Whether the inside of the segment crosses the inside of the triangle.
bool pierces(const Vec3d& p, const Vec3d& q, const Corners& t) {
  if (!(volume(t.a, t.b, t.c, p) * volume(t.a, t.b, t.c, q) < 0)) return false;
  const double u = volume(p, q, t.a, t.b), v = volume(p, q, t.b, t.c), w = volume(p, q, t.c, t.a);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

std::size_t piercings(const SceneArrays& s) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < s.triangles.size(); ++i)
    for (std::size_t j = 0; j < s.triangles.size(); ++j) {
      const Corners e = corners(s, i), t = corners(s, j);
      n += pierces(e.a, e.b, t) + pierces(e.b, e.c, t) + pierces(e.c, e.a, t);
    }
  return n;
}

/// Walls before a cell, spikes through them, and more behind; on whole numbers.
Case penetrating(std::uint64_t seed) {
  Random random(seed + 0x9e57);
  Case c;
  c.name = "penetrating";
  c.view = omni({0, 0, 0});
  const int walls = random.between(1, 3);
  for (int k = 0; k < walls; ++k) {
    const double z = -4 - random.between(0, 8), tilt = random.between(-2, 2),
                 half = random.pick({6.0, 12.0, 40.0});
    const Vec3d a{-half, -half, z - tilt}, b{half, -half, z + tilt}, d{half, half, z + tilt},
        e{-half, half, z - tilt};
    add_triangle(c.arrays, a, b, d);
    add_triangle(c.arrays, a, d, e);
  }
  const int spikes = random.between(1, 6);
  for (int k = 0; k < spikes; ++k) {
    const Vec3d tip = random.lattice(5) + Vec3d{0, 0, -6};
    add_triangle(c.arrays, tip, tip + random.lattice(4) + Vec3d{0, 0, -5},
                 tip + random.lattice(4) + Vec3d{0, 0, -6});
  }
  return c;
}

}  // namespace

TEST_CASE(
    "what exact samples and exact rays prove visible is not hidden by triangles that pierce each other") {
  std::size_t pierced = 0, proven = 0, hidden = 0, total = 0, cells = 0;
  for (const std::uint64_t seed : seeds(12)) {
    const Case c = penetrating(seed);
    if (piercings(c.arrays) == 0) continue;
    ++cells;
    pierced += piercings(c.arrays);
    Random random(seed + 4);
    const double edge = random.pick({0.25, 1.0, 3.0});
    const ViewCell cell = cell_around({0, 0, 0}, {edge, edge, edge});
    INFO(describe(c, cell));
    const Scene scene(c.arrays);
    CellOptions options;
    options.pixels = {4, 2};
    Context context;
    context.threads = 1;
    options.method = CellMethod::cos;
    const CellSet upper = visible_from_cell(scene, cell, options, context);
    options.method = CellMethod::cos_exact;
    const CellSet samples = visible_from_cell(scene, cell, options, context);
    for (const Witness& w : samples.set.witnesses) REQUIRE(upper.set.status[w.primitive] != Status::hidden);
    const CellRays rays(c.arrays, cell);
    for (int k = 0; k < 60; ++k)
      for (const PrimitiveId id : rays.seen(random)) REQUIRE(upper.set.status[id] != Status::hidden);
    proven += samples.set.witnesses.size();
    hidden += upper.bounds.hidden;
    total += scene.primitive_count();
  }
  WARN(cells << " cells with " << pierced << " piercings: of " << total << " triangles " << proven
             << " proven by samples, " << hidden << " hidden");
  if (seeds(12).size() > 100) {
    CHECK(cells > seeds(12).size() / 2);
    CHECK(10 * hidden > total - proven);
  }
}

}  // namespace provis::test
