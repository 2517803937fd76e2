// The constructor's checks and the hash.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/scene/files.hpp"
#include "tests/scene/fixed_scene.hpp"

namespace provis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Failure failure_after(void (*change)(SceneArrays&)) {
  SceneArrays arrays = fixed_arrays();
  change(arrays);
  return failure_of([&arrays] { Scene scene(arrays); });
}

std::string hash_after(void (*change)(SceneArrays&)) {
  SceneArrays arrays = fixed_arrays();
  change(arrays);
  return Scene(arrays).hash();
}

TEST_CASE("the hash is the one a second implementation computes") {
  std::string expected = read_text(std::string(PROVIS_SOURCE_DIR) + "/tests/scene/fixed_scene.sha256");
  expected.resize(64);
  CHECK(Scene(fixed_arrays()).hash() == expected);
}

TEST_CASE("the hash of an empty scene is that of its header alone") {
  // printf 'provis-scene-1\0' followed by 24 zero bytes, through sha256sum
  CHECK(Scene().hash() == "1ea013c0c2f8885fd70a3f48ffd4a60e0324cbada69afff61eecd613bce3664a");
}

TEST_CASE("the hash takes -0 for +0 and tells everything else apart") {
  const std::string hash = Scene(fixed_arrays()).hash();
  CHECK(hash_after([](SceneArrays& a) { a.vertices[0].x = -0.0; }) == hash);
  CHECK(hash_after([](SceneArrays& a) { a.vertices[0].x = 5e-324; }) != hash);
  CHECK(hash_after([](SceneArrays& a) { std::swap(a.triangles[0][1], a.triangles[0][2]); }) != hash);
  CHECK(hash_after([](SceneArrays& a) { a.triangle_flags[0] = see_through; }) != hash);
  CHECK(hash_after([](SceneArrays& a) { a.sphere_flags[0] = 0; }) != hash);
  CHECK(hash_after([](SceneArrays& a) { a.spheres[1].radius = 1; }) != hash);
  CHECK(hash_after([](SceneArrays& a) { a.vertices.push_back({0, 0, 0}); }) != hash);
}

TEST_CASE("the hash leaves out what is no geometry") {
  CHECK(hash_after([](SceneArrays& a) {
          a.node_names = {"a"};
          a.skipped = {1, 2};
          a.sources = {{0, 5, 0, 0, 0}};
        }) == Scene(fixed_arrays()).hash());
}

TEST_CASE("a scene keeps coordinates bit for bit") {
  const Scene scene(fixed_arrays());
  CHECK(std::signbit(scene.vertices()[1].y));
  CHECK(scene.vertices()[3].x == 5e-324);
  CHECK(scene.corner(1, 1) == scene.vertices()[3]);
  CHECK(scene.primitive_count() == 5);
}

TEST_CASE("the constructor names the first broken element") {
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.vertices[2].y = infinity; }), 2, "vertices[2]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.vertices[1].z = nan; }), 2, "vertices[1]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.triangles[1][2] = 4; }), 2, "triangles[1]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.triangle_flags.pop_back(); }), 2, "triangle_flags");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.triangle_flags[2] = 4; }), 2, "triangle_flags[2]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.sphere_flags.push_back(0); }), 2, "sphere_flags");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.sphere_flags[1] = 0x80; }), 2, "sphere_flags[1]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.spheres[1].radius = -1; }), 2, "spheres[1]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.spheres[0].radius = infinity; }), 2, "spheres[0]");
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.spheres[0].center.y = nan; }), 2, "spheres[0]");
}

TEST_CASE("source ranges cover all ids in order or are absent") {
  CHECK(failure_after([](SceneArrays& a) { a.sources = {{0, 2, 0, 0, 0}, {2, 3, 1, 0, 0}}; }).status == 0);
  CHECK_FAILURE(failure_after([](SceneArrays& a) { a.sources = {{0, 4, 0, 0, 0}}; }), 2, "sources");
  CHECK_FAILURE(failure_after([](SceneArrays& a) {
                  a.sources = {{0, 2, 0, 0, 0}, {3, 2, 0, 0, 0}};
                }),
                2, "sources[1]");
}

}  // namespace
}  // namespace provis
