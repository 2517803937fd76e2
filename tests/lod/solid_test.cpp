// Triangles in solids: the engine's answer, point by point against an oracle.

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"
#include "predicates/zero_area.hpp"
#include "src/lod/open_edge.hpp"
#include "src/lod/solid.hpp"
#include "tests/lod/inside_oracle.hpp"
#include "tests/support/environment.hpp"

namespace provis::test {
namespace {

SolidBox lattice_box(Random& random) {
  const Vec3d p = random.lattice(2);
  return {
      p, p + Vec3d{double(random.between(1, 3)), double(random.between(1, 3)), double(random.between(1, 3))}};
}

Soup any_solid(Random& random) {
  switch (random.between(0, 3)) {
    case 0:
      return box_solid(lattice_box(random));
    case 1:
      return box_solid(lattice_box(random), 1, random);
    case 2:
      return octahedron(random.lattice(2), random.between(1, 3));
    default:
      return ball(random.lattice(2), random.between(1, 2), 1);
  }
}

/// One to three solids that may touch, overlap, coincide, be turned inside out or be seen from one side.
SceneArrays any_chain(Random& random) {
  SceneArrays chain;
  Soup last;
  for (int n = random.between(1, 3); n > 0; --n) {
    Soup s = !last.empty() && random.chance(20) ? last : any_solid(random);
    last = s;
    if (random.chance(25)) s = reversed(std::move(s));
    add(chain, s, random.chance(50) ? single_sided : 0);
  }
  return chain;
}

Vec3d nudged(Vec3d p, Random& random) {
  double& x = component(p, random.between(0, 2));
  x = std::nextafter(x, random.chance(50) ? 100 : -100);
  return p;
}

/// A triangle of the chain, a part of one, one through it, one beside it, or one with a corner of the chain
/// where a cell that is not cut is asked first.
Corners any_triangle(const SceneArrays& chain, Random& random) {
  const auto any_vertex = [&] { return random.pick_from(chain.vertices); };
  const Triangle& of = random.pick_from(chain.triangles);
  const Vec3d &a = chain.vertices[of[0]], &b = chain.vertices[of[1]], &c = chain.vertices[of[2]];
  Corners t;
  switch (random.between(0, 5)) {
    case 0:
      t = {a, b, c};
      break;
    case 1:
      t = {a, 0.5 * a + 0.5 * b, 0.25 * a + 0.75 * c};
      break;
    case 2:
      t = {any_vertex(), any_vertex(), any_vertex()};
      break;
    case 3:
      t = {a, 2.0 * b - a, 2.0 * c - a};
      break;
    case 4: {
      const Vec3d d = 2.0 * random.lattice(2), e = 2.0 * random.lattice(2);
      t = {a + d, a + e, a - 0.5 * (d + e)};
      break;
    }
    default:
      t = {0.5 * random.lattice(6), 0.5 * random.lattice(6), 0.5 * random.lattice(6)};
  }
  if (random.chance(20)) t[random.below(3)] = nudged(t[random.below(3)], random);
  if (random.chance(30)) std::swap(t[0], t[1]);
  return t;
}

Exact3 exact_point(const lod::Point& p) {
  const auto number = [](const Rational& q) { return mpq_class(q.mpq()); };
  return {number(p.x), number(p.y), number(p.z)};
}

/// Of the triangle, mostly with parts that no lattice knows.
Exact3 any_point(const Corners& t, Random& random) {
  const auto weight = [&] {
    return mpq_class(random.pick({1, 1, 13, 101, 997, 1000000}) * random.between(1, 9));
  };
  const mpq_class u = weight(), v = weight(), w = weight();
  const Exact3 sum = u * test::exact_point(t[0]) + v * test::exact_point(t[1]) + w * test::exact_point(t[2]);
  return mpq_class(1 / (u + v + w)) * sum;
}

bool on(const Corners& t, const Exact3& p) {
  const Exact3 a = test::exact_point(t[0]), b = test::exact_point(t[1]), c = test::exact_point(t[2]);
  const Exact3 n = cross(Exact3(b - a), Exact3(c - a));
  const auto left = [&](const Exact3& q, const Exact3& r) {
    return dot(cross(Exact3(r - q), Exact3(p - q)), n) >= 0;
  };
  return dot(n, Exact3(p - a)) == 0 && left(a, b) && left(b, c) && left(c, a);
}

std::vector<PrimitiveId> all_ids(const Scene& scene) {
  std::vector<PrimitiveId> ids(scene.triangles().size());
  for (PrimitiveId id = 0; id < ids.size(); ++id) ids[id] = id;
  return ids;
}

std::string text(const Corners& t) {
  std::ostringstream out;
  out << std::hexfloat;
  for (const Vec3d& p : t) out << p.x << ',' << p.y << ',' << p.z << "  ";
  return out.str();
}

}  // namespace

TEST_CASE("a triangle is inside of a solid iff all its points are") {
  std::size_t inside = 0, outside = 0;
  for (const std::uint64_t seed : seeds(10)) {
    Random random(seed);
    SceneArrays arrays = any_chain(random);
    const double scale = random.pick({1.0, 1.0, 0x1p-300, 0x1p300});
    std::vector<Corners> triangles;
    for (int k = 0; k < 6; ++k) triangles.push_back(any_triangle(arrays, random));
    for (Vec3d& p : arrays.vertices) p = scale * p;
    const Scene scene(arrays);
    const lod::Chain chain(scene, all_ids(scene));
    REQUIRE(!open_edge(chain, offset::Seams(scene)));
    InsideOracle oracle(arrays, seed);
    for (Corners& t : triangles) {
      for (Vec3d& p : t) p = scale * p;
      if (zero_area(t[0], t[1], t[2])) continue;
      const bool fronts = random.chance(50);
      INFO("seed " << seed << (fronts ? ", fronts " : ", any side ") << text(t));
      const Exact3 a = test::exact_point(t[0]);
      const Exact3 n = cross(Exact3(test::exact_point(t[1]) - a), Exact3(test::exact_point(t[2]) - a));
      const auto holds = [&](const Exact3& p) {
        return fronts ? oracle.by_fronts(p, n) : oracle.by_any_side(p);
      };
      const auto escape = [&] {
        const RoundUp guard;
        return lod::outside(chain, fronts ? lod::Inside::fronts : lod::Inside::any_side, t[0], t[1], t[2]);
      }();
      ++(escape ? outside : inside);
      if (escape) {
        REQUIRE(on(t, exact_point(*escape)));
        REQUIRE(!holds(exact_point(*escape)));
      } else {
        for (int s = 0; s < 12; ++s) REQUIRE(holds(any_point(t, random)));
      }
    }
  }
  WARN(inside << " triangles inside, " << outside << " not");
  if (seeds(10).size() > 50) {
    CHECK(4 * inside > outside);
    CHECK(4 * outside > inside);
  }
}

TEST_CASE("a corner that touches a triangle from one side tells nothing of the triangle") {
  const Corners t{{{-8, -8, 0}, {8, -8, 0}, {0, 8, 0}}};
  const Vec3d tip{0, 0, 0};  // where an uncut triangle is asked
  for (const double up : {1.0, -1.0}) {
    const Vec3d a{-2, -2, up}, b{2, -2, up}, c{0, 2, up};
    Soup spike{{a, b, c}, {b, a, tip}, {c, b, tip}, {a, c, tip}};
    if (up < 0) spike = reversed(std::move(spike));
    const auto is_inside = [&](const Soup& soup, lod::Inside inside) {
      SceneArrays arrays;
      add(arrays, soup, 0);
      const Scene scene(arrays);
      const RoundUp guard;
      return !lod::outside(lod::Chain(scene, all_ids(scene)), inside, t[0], t[1], t[2]);
    };
    for (const auto inside : {lod::Inside::any_side, lod::Inside::fronts}) {
      CHECK_FALSE(is_inside(spike, inside));
      CHECK(is_inside(joined(box_solid({{-9, -9, -9}, {9, 9, 9}}), reversed(spike)), inside));
    }
  }
}

TEST_CASE("a ray through corners, along edges and in faces is no ray to count by") {
  const auto winding = [](const Soup& soup, const Vec3d& p) {
    const RoundUp guard;
    SceneArrays arrays;
    add(arrays, soup, 0);
    const Scene scene(arrays);
    return lod::Chain(scene, all_ids(scene)).winding(numbers<Rational>(p));
  };
  // The first direction that is tried, from anywhere.
  const Vec3d d = winding(octahedron({0, 0, 0}, 1), {5, 5, 5}).direction;
  const auto ends = [](double x) { return std::pair(std::min(x, -1.0), std::max(x, 1.0)); };
  const auto [x0, x1] = ends(d.x);
  const auto [y0, y1] = ends(d.y);
  const auto [z0, z1] = ends(d.z);
  const double far = 0x1p22;
  for (const SolidBox& box : {SolidBox{{x0, y0, z0}, {x1, y1, z1}}, {{x0, y0, -far}, {x1, y1, far}}}) {
    for (const Soup& soup : {box_solid(box), reversed(box_solid(box))}) {
      const lod::Winding w = winding(soup, {0, 0, 0});
      CHECK(std::abs(w.number) == 1);
      CHECK(w.direction != d);
    }
  }
  // A corner of something else on the way, then a face in the plane of the ray, then an edge along it.
  CHECK(winding(octahedron(d + Vec3d{16, 0, 0}, 16), {0, 0, 0}).number == 0);
  const Vec3d aside{1, 2, -4}, over{-2, 1, 8};
  for (const Vec3d& start : {d, d + aside, d - aside}) {
    const Vec3d a = start, b = start + d, c = start + aside, e = start + over;
    CHECK(winding({{a, b, c}, {a, c, e}, {c, b, e}, {b, a, e}}, {0, 0, 0}).number == 0);
  }
}

TEST_CASE("a surface is open where an edge lacks its neighbour, and nowhere else") {
  for (const std::uint64_t seed : seeds(2)) {
    Random random(seed);
    const SceneArrays closed = any_chain(random);
    const Scene whole(closed);
    REQUIRE(!open_edge(lod::Chain(whole, all_ids(whole)), offset::Seams(whole)));
    SceneArrays torn = closed;
    const auto hole = static_cast<std::ptrdiff_t>(random.below(torn.triangles.size()));
    torn.triangles.erase(torn.triangles.begin() + hole);
    torn.triangle_flags.pop_back();
    const Scene scene(torn);
    REQUIRE(open_edge(lod::Chain(scene, all_ids(scene)), offset::Seams(scene)));
    SceneArrays turned = closed;
    std::swap(turned.triangles[static_cast<std::size_t>(hole)][0],
              turned.triangles[static_cast<std::size_t>(hole)][1]);
    const Scene wrong(turned);
    REQUIRE(open_edge(lod::Chain(wrong, all_ids(wrong)), offset::Seams(wrong)));
  }
}

}  // namespace provis::test
