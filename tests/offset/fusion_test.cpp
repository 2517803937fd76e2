// Shared edges, T-junctions, and what fuses along them.

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "src/offset/fusion.hpp"
#include "tests/offset/lower_face.hpp"

namespace provis::test {
namespace {

using namespace provis::offset;

const ViewCell cell{{-0.5, -0.5, 0}, {0.5, 0.5, 1}, {}};

struct Seen {
  Scene scene;
  RoundUp guard;
  Seams seams;
  Facets facets;
  Mesh mesh;

  explicit Seen(SceneArrays arrays)
      : scene(std::move(arrays)),
        seams(scene),
        facets(facets_of(scene, seams, lower_face(cell))),
        mesh(facets.all, seams) {}

  /// Members of the set grown from a facet where every edge may be crossed that `open` says.
  template <class Open>
  std::size_t grown(std::uint32_t seed, const Open& open) {
    Fusion fusion(mesh);
    const auto set = fusion.grow(
        seed, 100, [](std::uint32_t) { return true; }, open);
    return set ? set->size() : 0;
  }
};

SceneArrays scene(std::vector<Vec3d> vertices, std::vector<Triangle> triangles) {
  SceneArrays s;
  s.vertices = std::move(vertices);
  s.triangle_flags.assign(triangles.size(), 0);
  s.triangles = std::move(triangles);
  return s;
}

/// Edges inside the square |x|, |y| < 1 only.
bool inner(const Mesh::Edge& e) {
  const auto on_border = [](double a, double b) { return a == b && (a == 1 || a == -1); };
  const Vec3d &a = *e.ends[0], &b = *e.ends[1];
  return !on_border(a.x, b.x) && !on_border(a.y, b.y);
}

}  // namespace

TEST_CASE("two triangles fuse along an edge that they share, whatever their windings") {
  for (const bool turned : {false, true}) {
    const Triangle second = turned ? Triangle{0, 3, 2} : Triangle{0, 2, 3};
    Seen s(scene({{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}}, {{0, 1, 2}, second}));
    CHECK(s.grown(0, inner) == 2);
    CHECK(s.grown(1, inner) == 2);
    CHECK(s.grown(0, [](const Mesh::Edge&) { return true; }) == 0);  // the border is open
    CHECK(s.grown(0, [](const Mesh::Edge&) { return false; }) == 1);
  }
}

TEST_CASE("equal positions are one vertex, others are not, however near") {
  const Vec3d a{-1, -1, -1}, b{1, 1, -1}, nearly{1, 0x1.fffffffffffffp-1, -1};
  CHECK(Seen(scene({a, {1, -1, -1}, b, a, b, {-1, 1, -1}}, {{0, 1, 2}, {3, 4, 5}})).grown(0, inner) == 2);
  CHECK(Seen(scene({a, {1, -1, -1}, b, a, nearly, {-1, 1, -1}}, {{0, 1, 2}, {3, 4, 5}})).grown(0, inner) ==
        0);
}

TEST_CASE("triangles on the same side of an edge do not close it") {
  CHECK(Seen(scene({{-1, -1, -1}, {1, 1, -1}, {1, -1, -1}, {1, -1, -2}}, {{0, 1, 2}, {0, 1, 3}}))
            .grown(0, inner) == 0);
}

TEST_CASE("a T-junction is closed where the vertex lies exactly on the edge") {
  const auto junction = [](double x) {
    // One triangle above the line y = 0, two below it that meet at (x, 0).
    return scene({{-1, 0, -1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}, {1, -1, -1}, {x, 0, -1}, {0, -1, -1}},
                 {{0, 1, 2}, {0, 3, 5}, {5, 4, 1}, {3, 4, 5}});
  };
  const auto along = [](const Mesh::Edge& e) { return e.ends[0]->y == 0 && e.ends[1]->y == 0; };
  CHECK(Seen(junction(0.25)).grown(0, along) == 3);
  CHECK(Seen(junction(0.25)).grown(0, inner) == 0);  // its other edges are open
  CHECK(Seen(scene({{-1, 0, -1}, {1, 0, -1}, {0, 1, -1}, {-1, -1, -1}, {1, -1, -1}, {0.25, 0x1p-60, -1}},
                   {{0, 1, 2}, {0, 3, 5}, {5, 4, 1}}))
            .grown(0, along) == 0);
}

TEST_CASE("facets know what can occlude from the face") {
  SceneArrays s = scene({{-9, -9, -1},
                         {9, -9, -1},
                         {0, 9, -1},  // across, as seen from the face
                         {0, -9, -1},
                         {0, 9, -1},
                         {0, 0, -9},  // its plane cuts the face
                         {-9, -9, 0},
                         {9, -9, 0},
                         {0, 9, 0},  // in the face's plane
                         {-9, -9, 2},
                         {9, -9, 2},
                         {0, 9, 2}},  // behind it
                        {{0, 1, 2}, {0, 2, 1}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}, {0, 1, 2}});
  s.triangle_flags = {single_sided, single_sided, 0, 0, 0, see_through};
  Seen seen(s);
  std::vector<PrimitiveId> ids, occluders;
  for (const Facet& f : seen.facets.all) {
    ids.push_back(f.id);
    if (f.occludes) occluders.push_back(f.id);
  }
  // 0 looks along +z, towards the face, which 1 does not.
  CHECK(ids == std::vector<PrimitiveId>{0, 2, 5});
  CHECK(occluders == std::vector<PrimitiveId>{0});
  CHECK(seen.facets.facing_unknown == 1);
}

}  // namespace provis::test
