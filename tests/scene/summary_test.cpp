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
