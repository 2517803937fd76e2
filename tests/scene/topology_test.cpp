// Open edges and duplicates: scenes counted by hand, and generated ones against an obvious slow count.

#include "provis/topology.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <set>

#include "predicates/zero_area.hpp"
#include "tests/scene/files.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/mesh_builder.hpp"

namespace provis::test {
namespace {

SceneArrays arrays_of(std::vector<Vec3d> vertices, std::vector<Triangle> triangles) {
  SceneArrays arrays;
  arrays.vertices = std::move(vertices);
  arrays.triangle_flags.assign(triangles.size(), 0);
  arrays.triangles = std::move(triangles);
  return arrays;
}

void check_counts(const Topology& t, std::size_t duplicates, std::size_t edges, std::size_t open) {
  CHECK(t.duplicate_triangles == duplicates);
  CHECK(t.edges == edges);
  CHECK(t.open_edges == open);
}

/// Every edge against every other, every triangle against every earlier one.
Topology slow_topology(const Scene& scene) {
  using Edge = std::pair<Vec3d, Vec3d>;
  const auto same = [](const Edge& e, const Edge& f) {
    return e == f || (e.first == f.second && e.second == f.first);
  };
  Topology result;
  std::vector<std::pair<Edge, int>> edges;
  std::vector<std::array<Vec3d, 3>> seen;
  for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
    const std::array corners{scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)};
    if (zero_area(corners[0], corners[1], corners[2])) continue;
    result.duplicate_triangles += std::ranges::any_of(
        seen, [&](const auto& other) { return std::ranges::is_permutation(other, corners); });
    seen.push_back(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge{corners[k], corners[(k + 1) % 3]};
      const auto found = std::ranges::find_if(edges, [&](const auto& e) { return same(e.first, edge); });
      if (found == edges.end())
        edges.push_back({edge, 1});
      else
        ++found->second;
    }
  }
  result.edges = edges.size();
  for (const auto& [edge, count] : edges) result.open_edges += count == 1;
  return result;
}

TEST_CASE("a tetrahedron is closed, and without one face it has three open edges") {
  const std::vector<Vec3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  check_counts(topology(Scene(arrays_of(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}))), 0, 6, 0);
  check_counts(topology(Scene(arrays_of(corners, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}}))), 0, 6, 3);
}

TEST_CASE("a box of quads whose corners are all stored apart is closed") {
  Random random(7);
  for (const bool share : {false, true}) {
    MeshBuilder builder(random, share);
    builder.box({0, 0, 0}, {1, 2, 3});
    check_counts(topology(Scene(builder.arrays())), 0, 18, 0);
    MeshBuilder without_lid(random, share);
    without_lid.box({0, 0, 0}, {1, 2, 3}, 31);
    check_counts(topology(Scene(without_lid.arrays())), 0, 17, 4);
  }
}

TEST_CASE("duplicates are found in any rotation and winding, by position, and -0 is 0") {
  const std::vector<Vec3d> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {1, -0.0, 0}};
  for (const Triangle& other :
       {Triangle{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}, {3, 1, 2}, {2, 4, 3}})
    check_counts(topology(Scene(arrays_of(corners, {{0, 1, 2}, other}))), 1, 3, 0);
  check_counts(topology(Scene(arrays_of(corners, {{0, 1, 2}, {2, 4, 3}, {1, 2, 0}}))), 2, 3, 0);
  const std::vector<Vec3d> near = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 5e-324}};
  check_counts(topology(Scene(arrays_of(near, {{0, 1, 2}, {3, 1, 2}}))), 0, 5, 4);
}

TEST_CASE("an edge of three triangles is not open, and degenerate triangles close nothing") {
  const std::vector<Vec3d> corners = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 0.5}};
  check_counts(topology(Scene(arrays_of(corners, {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}}))), 0, 7, 6);
  check_counts(topology(Scene(arrays_of(corners, {{0, 1, 2}, {0, 5, 1}, {0, 0, 2}, {1, 1, 1}}))), 0, 3, 3);
  check_counts(topology(Scene(arrays_of(corners, {{0, 5, 1}, {0, 5, 1}}))), 0, 0, 0);
}

TEST_CASE("nothing has no edges") {
  check_counts(topology(Scene()), 0, 0, 0);
  check_counts(topology(Scene(arrays_of({{1, 2, 3}}, {}))), 0, 0, 0);
}

TEST_CASE("topology agrees with the slow count on generated scenes") {
  for (const std::uint64_t seed : seeds(20)) {
    INFO("PROVIS_SEED=" << seed);
    const Scene scene(generate(seed).arrays);
    const Topology expected = slow_topology(scene);
    check_counts(topology(scene), expected.duplicate_triangles, expected.edges, expected.open_edges);
  }
}

/// So many triangles between so few points that most edges have many and some triangles have doubles.
Scene crowd(std::uint64_t seed, std::size_t triangles, int size) {
  Random random(seed);
  SceneArrays arrays;
  for (std::size_t v = 0; v < 3 * triangles; ++v) {
    Vec3d p = random.lattice(size);
    if (p.x == 0 && random.chance(50)) p.x = -0.0;
    arrays.vertices.push_back(p);
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto i = static_cast<std::uint32_t>(3 * t);
    arrays.triangles.push_back({i, i + 1, i + 2});
  }
  arrays.triangle_flags.assign(triangles, 0);
  return Scene(std::move(arrays));
}

TEST_CASE("topology agrees with the slow count where nearly everything coincides") {
  for (const std::uint64_t seed : seeds(1)) {
    INFO("PROVIS_SEED=" << seed);
    const Scene scene = crowd(seed, 400, 1);
    const Topology expected = slow_topology(scene);
    CHECK((expected.duplicate_triangles > 0 && expected.open_edges > 0));
    check_counts(topology(scene), expected.duplicate_triangles, expected.edges, expected.open_edges);
  }
}

TEST_CASE("the number of threads does not change the counts") {
  const Scene scene = crowd(1, 100000, 3);
  Context one;
  one.threads = 1;
  const Topology expected = topology(scene, one);
  CHECK((expected.duplicate_triangles > 100 && expected.open_edges > 100));
  const SceneSummary counts = summarize(scene, one);
  for (const int threads : {2, 7}) {
    Context context;
    context.threads = threads;
    const Topology t = topology(scene, context);
    check_counts(t, expected.duplicate_triangles, expected.edges, expected.open_edges);
    CHECK(summarize(scene, context).degenerate_triangles == counts.degenerate_triangles);
  }
}

TEST_CASE("counting can be interrupted") {
  std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  CHECK(failure_of([&] { topology(crowd(1, 10, 1), context); }).status == 130);
  CHECK(failure_of([&] { summarize(crowd(1, 10, 1), context); }).status == 130);
}

}  // namespace
}  // namespace provis::test
