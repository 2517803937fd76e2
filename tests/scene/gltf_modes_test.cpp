// Primitive modes and index types.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

/// Triangles of a primitive over vertices that were numbered by their x coordinate.
std::vector<Triangle> triangles_of(const Scene& scene) {
  return {scene.triangles().begin(), scene.triangles().end()};
}

Scene load_mode(int mode, int vertices) {
  GltfBuilder builder;
  builder.root({{"mesh", builder.mesh(builder.positions(numbered_positions(vertices)), {{"mode", mode}})}});
  return builder.load();
}

template <class T>
GltfBuilder indexed(int mode, int vertices, const std::vector<T>& indices) {
  GltfBuilder builder;
  const int accessor = builder.indices(indices);
  builder.root({{"mesh", builder.mesh(builder.positions(numbered_positions(vertices)),
                                      {{"mode", mode}, {"indices", accessor}})}});
  return builder;
}

enum Mode { points, lines, line_loop, line_strip, triangles, strip, fan };

TEST_CASE("modes without indices give glTF's triangles in glTF's order") {
  CHECK(triangles_of(load_mode(triangles, 6)) == std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}});
  CHECK(triangles_of(load_mode(strip, 6)) ==
        std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}});
  CHECK(triangles_of(load_mode(fan, 5)) == std::vector<Triangle>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}});
}

TEST_CASE("triangles are what a primitive without a mode holds") {
  CHECK(triangles_of(one_triangle().load()) == std::vector<Triangle>{{0, 1, 2}});
}

TEMPLATE_TEST_CASE("every index type is read", "", std::uint8_t, std::uint16_t, std::uint32_t) {
  const std::vector<TestType> order = {4, 2, 0, 1, 3, 4};
  CHECK(triangles_of(indexed<TestType>(triangles, 5, order).load()) ==
        std::vector<Triangle>{{4, 2, 0}, {1, 3, 4}});
  CHECK(triangles_of(indexed<TestType>(strip, 5, order).load()) ==
        std::vector<Triangle>{{4, 2, 0}, {2, 1, 0}, {0, 1, 3}, {1, 4, 3}});
  CHECK(triangles_of(indexed<TestType>(fan, 5, order).load()) ==
        std::vector<Triangle>{{2, 0, 4}, {0, 1, 4}, {1, 3, 4}, {3, 4, 4}});
}

TEST_CASE("vertices are kept in loading order, used or not") {
  const Scene scene = indexed<std::uint8_t>(triangles, 5, {4, 2, 0}).load();
  REQUIRE(scene.vertices().size() == 5);
  CHECK(scene.vertices()[3] == Vec3d{3, 0, 0});
  CHECK(scene.corner(0, 0) == Vec3d{4, 0, 0});
}

TEST_CASE("points and lines are counted as skipped") {
  CHECK(load_mode(points, 5).skipped().points == 5);
  CHECK(load_mode(lines, 6).skipped().lines == 3);
  CHECK(load_mode(line_loop, 5).skipped().lines == 5);
  CHECK(load_mode(line_strip, 5).skipped().lines == 4);
  CHECK(indexed<std::uint16_t>(line_strip, 5, {0, 1, 2}).load().skipped().lines == 2);
  CHECK(indexed<std::uint16_t>(points, 5, {0, 1, 2}).load().skipped().points == 3);
  const Scene scene = load_mode(points, 5);
  CHECK(scene.triangles().empty());
  CHECK(scene.vertices().empty());
}

TEST_CASE("too few corners for a strip or fan are no triangle") {
  CHECK(load_mode(strip, 2).triangles().empty());
  CHECK(load_mode(fan, 1).triangles().empty());
}

TEST_CASE("an incomplete triangle is an error") {
  GltfBuilder builder;
  builder.root({{"mesh", builder.mesh(builder.positions(numbered_positions(4)))}});
  CHECK_FAILURE(builder.failure(), 2, "meshes[0].primitives[0]");
}

TEST_CASE("the primitive restart value is an error in every type") {
  CHECK_FAILURE(indexed<std::uint8_t>(strip, 256, {0, 1, 255}).failure(), 2, "accessors[0]");
  CHECK_FAILURE(indexed<std::uint16_t>(strip, 5, {0, 65535, 2}).failure(), 2, "accessors[0]");
  CHECK_FAILURE(indexed<std::uint32_t>(strip, 5, {0, 1, 0xFFFFFFFF}).failure(), 2, "accessors[0]");
  // 254 is an index like any other
  CHECK(indexed<std::uint8_t>(strip, 256, {0, 1, 254}).load().triangles().size() == 1);
}

TEST_CASE("an index out of range is an error that names accessor and element") {
  const Failure failure = indexed<std::uint16_t>(triangles, 5, {0, 1, 5}).failure();
  CHECK_FAILURE(failure, 2, "meshes[0].primitives[0]");
  CHECK_THAT(failure.message, Catch::Contains("accessors[0]: element 2 is vertex 5 of 5"));
}

TEST_CASE("an unknown mode is an error") {
  CHECK_FAILURE(one_triangle({{"mode", 7}}).failure(), 2, "meshes[0].primitives[0].mode");
}

}  // namespace
}  // namespace provis
