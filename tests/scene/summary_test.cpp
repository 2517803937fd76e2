// summarize: counts and extent.
#include <catch2/catch.hpp>

#include "tests/scene/fixed_scene.hpp"
#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

TEST_CASE("a summary counts primitives, flags and degenerate ones") {
  const SceneSummary s = summarize(Scene(fixed_arrays()));
  CHECK((s.triangles == 3 && s.spheres == 2 && s.vertices == 4));
  CHECK((s.single_sided == 3 && s.see_through == 2));
  CHECK((s.degenerate_triangles == 1 && s.degenerate_spheres == 1));
}

TEST_CASE("each combination of sides and opacity is counted apart") {
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  arrays.triangle_flags = {0, 1, 1, 2, 2, 2, 3, 3, 3, 3};
  arrays.triangles.resize(10, {0, 1, 2});
  arrays.spheres.resize(3, {{0, 0, 0}, 1});
  arrays.sphere_flags = {single_sided, single_sided | see_through, single_sided};
  const SceneSummary s = summarize(Scene(arrays));
  CHECK(s.triangles_by_flags == std::array<std::size_t, 4>{1, 2, 3, 4});
  CHECK(s.spheres_by_flags == std::array<std::size_t, 4>{0, 2, 0, 1});
  CHECK((s.single_sided == 9 && s.see_through == 8));
}

TEST_CASE("spheres are measured, and an absence of spheres is not") {
  SceneArrays arrays;
  arrays.spheres = {{{0, 0, 0}, 3}, {{0, 0, 0}, 0.5}, {{0, 0, 0}, 7}, {{0, 0, 0}, 2}};
  arrays.sphere_flags.resize(4, 0);
  const SceneSummary s = summarize(Scene(arrays));
  CHECK((s.smallest_radius == 0.5 && s.largest_radius == 7));
  CHECK((summarize(Scene()).smallest_radius == 0 && summarize(Scene()).largest_radius == 0));
}

TEST_CASE("the exact arrays are weighed") {
  // 24 bytes a vertex, 13 a triangle with its flags, 33 a sphere.
  CHECK(array_bytes(Scene(fixed_arrays())) == 4 * 24 + 3 * 13 + 2 * 33);
}

TEST_CASE("zero area is decided exactly") {
  SceneArrays arrays;
  // (0.1, 0.1), (0.2, 0.2), (0.3, 0.3) lie on one line although 0.1 + 0.2 is not 0.3; one ulp breaks it.
  arrays.vertices = {{0.1, 0.1, 0},  {0.2, 0.2, 0},  {0.3, 0.3, 0}, {0.3, std::nextafter(0.3, 1.0), 0},
                     {5e-324, 0, 0}, {0, 5e-324, 0}, {0, 0, 0}};
  arrays.triangles = {{0, 1, 2}, {0, 1, 3}, {4, 5, 6}, {0, 0, 1}};
  arrays.triangle_flags = {0, 0, 0, 0};
  CHECK(summarize(Scene(arrays)).degenerate_triangles == 2);
}

TEST_CASE("the extent covers what is referenced and spheres, and nothing else") {
  SceneArrays arrays;
  arrays.vertices = {{1, 2, 3}, {4, 2, 1}, {2, 7, 3}, {100, 100, 100}};
  arrays.triangles = {{0, 1, 2}};
  arrays.triangle_flags = {0};
  SceneSummary s = summarize(Scene(arrays));
  CHECK(s.lower == Vec3d{1, 2, 1});
  CHECK(s.upper == Vec3d{4, 7, 3});
  arrays.spheres = {{{0, 3, 3}, 2}};
  arrays.sphere_flags = {0};
  s = summarize(Scene(arrays));
  CHECK(s.lower == Vec3d{-2, 1, 1});
  CHECK(s.upper == Vec3d{4, 7, 5});
}

TEST_CASE("an empty scene has a zero extent") {
  CHECK(summarize(Scene()).lower == Vec3d{});
  CHECK(summarize(Scene()).upper == Vec3d{});
}

}  // namespace
}  // namespace provis
