// R12: what a perturbed scene may and may not change.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <set>

#include "tests/scene/files.hpp"
#include "tests/scene/fixed_scene.hpp"

namespace provis {
namespace {

/// A grid of split triangles: every inner position occurs several times.
Scene grid() {
  SceneArrays arrays;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      const auto first = static_cast<std::uint32_t>(arrays.vertices.size());
      const double x = i, y = j;
      arrays.vertices.insert(arrays.vertices.end(), {{x, y, 0}, {x + 1, y, 0}, {x, y + 1, -0.0}});
      arrays.triangles.push_back({first, first + 1, first + 2});
      arrays.triangle_flags.push_back(static_cast<std::uint8_t>(i % 4));
    }
  arrays.spheres = {{{1, 2, 0}, 0.5}};
  arrays.sphere_flags = {single_sided};
  arrays.sources = {{0, 401, -1, -1, -1}};
  return Scene(arrays);
}

TEST_CASE("a perturbed scene is a function of scene, delta and seed") {
  const Scene scene = grid();
  CHECK(perturb(scene, 1e-8, 7).hash() == perturb(scene, 1e-8, 7).hash());
  CHECK(perturb(scene, 1e-8, 7).hash() != perturb(scene, 1e-8, 8).hash());
  CHECK(perturb(scene, 1e-8, 7).hash() != perturb(scene, 2e-8, 7).hash());
  CHECK(perturb(scene, 1e-8, 7).hash() != scene.hash());
}

TEST_CASE("the numbers are the same on every machine") {
  // Computed in Python from the definition in src/scene/README.md.
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, 2, 3}};
  const Scene moved = perturb(Scene(arrays), 0.5, 42);
  CHECK(moved.vertices()[0] == Vec3d{-0.16748611075316755, -0.36750960036674196, -0.3547534514768149});
  CHECK(moved.vertices()[1] == Vec3d{0.5685652407637092, 2.359144985061728, 3.419297187745259});
}

TEST_CASE("equal positions move together, signed zeros included") {
  const Scene scene = grid(), moved = perturb(scene, 0.25, 3);
  for (std::size_t i = 0; i < scene.vertices().size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (scene.vertices()[i] == scene.vertices()[j]) CHECK(moved.vertices()[i] == moved.vertices()[j]);
  // The sphere's center (1, 2, 0) is a grid point too.
  for (std::size_t i = 0; i < scene.vertices().size(); ++i)
    if (scene.vertices()[i] == scene.spheres()[0].center)
      CHECK(moved.vertices()[i] == moved.spheres()[0].center);
}

TEST_CASE("different positions move on their own, every coordinate too, by delta at most") {
  const Scene scene = grid(), moved = perturb(scene, 0.25, 3);
  std::set<double> offsets;
  double sum = 0, least = 1, most = -1;
  for (std::size_t i = 0; i < scene.vertices().size(); ++i) {
    const Vec3d d = moved.vertices()[i] - scene.vertices()[i];
    for (const double x : {d.x, d.y, d.z}) {
      REQUIRE(std::fabs(x) <= 0.25);
      if (offsets.insert(x).second) sum += x;
      least = std::min(least, x);
      most = std::max(most, x);
    }
  }
  // 21 * 21 - 1 positions of three coordinates; a shared offset would show as a missing one.
  CHECK(offsets.size() == 3 * 440);
  CHECK(std::fabs(sum / static_cast<double>(offsets.size())) < 0.02);
  CHECK(least < -0.245);
  CHECK(most > 0.245);
}

TEST_CASE("perturbing changes positions and nothing else") {
  const Scene scene = grid(), moved = perturb(scene, 1e-3, 1);
  CHECK(std::equal(scene.triangles().begin(), scene.triangles().end(), moved.triangles().begin()));
  CHECK(std::equal(scene.triangle_flags().begin(), scene.triangle_flags().end(),
                   moved.triangle_flags().begin()));
  CHECK(moved.spheres()[0].radius == 0.5);
  CHECK(moved.sphere_flags()[0] == single_sided);
  CHECK(moved.sources().size() == 1);
}

TEST_CASE("delta must be finite and no smaller than one ulp of the largest coordinate") {
  SceneArrays arrays;
  arrays.vertices = {{1, 0, 0}, {0, -1024, 0}};
  const Scene scene(arrays);
  const double ulp = std::ldexp(1.0, 10 - 52);
  CHECK(failure_of([&] { perturb(scene, ulp, 0); }).status == 0);
  CHECK_FAILURE(failure_of([&] { perturb(scene, std::nextafter(ulp, 0), 0); }), 1, "--perturb");
  CHECK_FAILURE(failure_of([&] { perturb(scene, 0, 0); }), 1, "--perturb");
  CHECK_FAILURE(failure_of([&] { perturb(scene, -1, 0); }), 1, "--perturb");
  CHECK_FAILURE(failure_of([&] { perturb(scene, std::numeric_limits<double>::quiet_NaN(), 0); }), 1,
                "--perturb");
  CHECK_FAILURE(failure_of([&] { perturb(scene, std::numeric_limits<double>::infinity(), 0); }), 1,
                "--perturb");
  arrays.vertices[0].x = std::numeric_limits<double>::max();
  CHECK_FAILURE(failure_of([&] { perturb(Scene(arrays), 1e305, 0); }), 1, "--perturb");
}

TEST_CASE("an empty scene stays empty") { CHECK(perturb(Scene(), 1, 0).hash() == Scene().hash()); }

}  // namespace
}  // namespace provis
