// The moments at which a viewpoint lies on an occluder: against plain rational arithmetic, and just after.

#include <catch2/catch.hpp>

#include <algorithm>

#include "src/segment/blocked.hpp"
#include "tests/support/random.hpp"
#include "tests/support/triangles.hpp"

namespace provis::test {
namespace {

Vec3<ExactTime> exact(const Vec3d& p) { return {ExactTime(p.x), ExactTime(p.y), ExactTime(p.z)}; }

/// In the closed triangle: by its definition, with nothing decided early.
bool holds(const Vec3d& a, const Vec3d& b, const Vec3d& c, const Vec3<ExactTime>& v) {
  const Vec3<ExactTime> p = exact(a), q = exact(b), r = exact(c), n = cross(q - p, r - p);
  return dot(n, v - p) == 0 && dot(n, cross(q - p, v - p)) >= 0 && dot(n, cross(r - q, v - q)) >= 0 &&
         dot(n, cross(p - r, v - r)) >= 0;
}

}  // namespace

TEST_CASE("a moment is blocked where some occluder holds the viewpoint") {
  Random random(31);
  std::size_t blocked = 0, free = 0;
  for (int round = 0; round < 400; ++round) {
    SceneArrays arrays;
    for (int k = 0; k < 12; ++k)
      add_triangle(arrays, random.lattice(2), random.lattice(2), random.lattice(2),
                   static_cast<std::uint8_t>(random.chance(20) ? see_through : 0));
    const Scene scene(std::move(arrays));
    const Vec3d from = random.lattice(2), to = random.lattice(2);
    if (from == to) continue;
    const BlockedTimes times(scene, from, to);
    for (int k = 0; k <= 48; ++k) {
      // Lattice planes are crossed at small fractions; a little later nothing may be left of that.
      const ExactTime late = ExactTime(k % 2) / ExactTime(0x1p60),
                      t = ExactTime(k / 2) / ExactTime(24) + late;
      const Vec3<ExactTime> v = exact(from) + t * (exact(to) - exact(from));
      bool on = false;
      for (std::size_t i = 0; i < scene.triangles().size(); ++i)
        on = on || (!(scene.triangle_flags()[i] & see_through) && scene.corner(i, 0) != scene.corner(i, 1) &&
                    cross(scene.corner(i, 1) - scene.corner(i, 0), scene.corner(i, 2) - scene.corner(i, 0)) !=
                        Vec3d{0, 0, 0} &&
                    holds(scene.corner(i, 0), scene.corner(i, 1), scene.corner(i, 2), v));
      INFO("round " << round << ", moment " << k);
      if (t <= ExactTime(1)) CHECK(times.at(t) == on);
      ++(on ? blocked : free);
    }
  }
  CHECK(std::min(blocked, free) > 500);
}

}  // namespace provis::test
