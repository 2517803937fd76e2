// What a prepared segment says of triangles, against exact determinants; and what shadows leave out.

#include <catch2/catch.hpp>

#include <algorithm>

#include "predicates/environment.hpp"
#include "src/offset/shadows.hpp"
#include "src/offset/sight_line.hpp"
#include "tests/offset/lower_face.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

using namespace provis::offset;

const ViewCell cell{{-1, -1, 0}, {1, 1, 2}, {}};

/// Small whole numbers, so that much is degenerate: corners on the segment, edges through it, planes along
/// it.
struct Case {
  Scene scene;
  Seams seams;
  Facets facets;

  explicit Case(SceneArrays arrays)
      : scene(std::move(arrays)), seams(scene), facets(facets_of(scene, seams, lower_face(cell))) {}
};

Case some_triangles(Random& random, std::size_t count) {
  SceneArrays s;
  for (std::size_t k = 0; k < 3 * count; ++k) s.vertices.push_back(random.lattice(2) + Vec3d{0, 0, -2});
  for (std::uint32_t t = 0; t < count; ++t) s.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  s.triangle_flags.assign(count, 0);
  return Case(std::move(s));
}

Vec3d some_viewpoint(Random& random) {
  Vec3d v = 0.25 * random.lattice(4);
  v.z = 0;
  return v;
}

/// The signs of the three turns, sorted: exact.
std::array<Sign, 3> turns(const Facet& f, const Vec3d& from, const Vec3d& to) {
  std::array<Sign, 3> s;
  for (std::size_t k = 0; k < 3; ++k) s[k] = turn(*f.p[k], *f.p[(k + 1) % 3], to, from);
  std::sort(s.begin(), s.end());
  return s;
}

}  // namespace

TEST_CASE("a prepared segment agrees with exact determinants") {
  const RoundUp guard;
  Random random(20261201);
  std::size_t hit = 0, missed = 0, open = 0;
  for (int round = 0; round < 2000; ++round) {
    const Case c = some_triangles(random, 8);
    const Vec3d from = some_viewpoint(random), to = random.lattice(1) + Vec3d{0, 0, -2};
    const SightLine sight(numbers<Interval>(from), numbers<Interval>(to));
    for (const Facet& f : c.facets.all) {
      const std::array<Sign, 3> s = turns(f, from, to);
      const bool inside = s[0] == Sign::positive || (!f.faced && s[2] == Sign::negative);
      const std::optional<bool> aimed = sight.aims_at(f), crossed = sight.crosses(f);
      INFO("round " << round << ", triangle " << f.id);
      if (aimed) CHECK(*aimed == inside);
      // Whole numbers are not rounded: what is certainly inside or outside is known.
      if (f.faced && inside) CHECK(aimed == true);
      if (s[0] == Sign::negative && s[2] == Sign::positive) CHECK(aimed == false);
      if (f.faced) {
        const Sign side = beyond(f, to);
        if (crossed) CHECK(*crossed == (inside && side == Sign::positive));
        if (inside && side != Sign::zero) CHECK(crossed.has_value());
      }
      ++(!crossed ? open : *crossed ? hit : missed);
    }
  }
  CHECK(std::min({hit, missed, open}) > 100);
}

TEST_CASE("shadows leave out nothing that a segment in the beam may cross") {
  const RoundUp guard;
  Random random(7);
  std::size_t visited = 0, left_out = 0;
  const Face face = lower_face(cell);
  const std::vector<Raster> rasters = rasters_of(cell, face, {8, 8});
  for (int round = 0; round < 500; ++round) {
    const Case c = some_triangles(random, 24);
    for (const Raster& raster : rasters) {
      const Shafts shafts(raster.frame);
      const Beam beam(face, raster, shafts, raster.frame.window);
      std::vector<Entry> list;
      for (std::uint32_t f = 0; f < c.facets.all.size(); ++f) {
        Entry e;
        e.facet = f;
        list.push_back(e);
      }
      const Shadows shadows(beam, list, c.facets.all);
      const Vec3d from = some_viewpoint(random), to = random.lattice(4) + Vec3d{0, 0, -9};
      std::vector<char> met(c.facets.all.size(), 0);
      shadows.along(numbers<Interval>(from), numbers<Interval>(to), HUGE_VAL, [&](std::uint32_t f) {
        met[f] = 1;
        return false;
      });
      for (std::size_t f = 0; f < met.size(); ++f) {
        const std::array<Sign, 3> s = turns(c.facets.all[f], from, to);
        INFO("round " << round << ", triangle " << c.facets.all[f].id);
        // All corners lie between both heights, so the segment meets what its line meets.
        if (s[0] == Sign::positive || s[2] == Sign::negative) CHECK(met[f]);
        ++(met[f] ? visited : left_out);
      }
    }
  }
  CHECK(std::min(visited, left_out) > 1000);
}

}  // namespace provis::test
