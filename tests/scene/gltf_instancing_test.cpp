// EXT_mesh_gpu_instancing: order, maps, winding and ids of the copies, and what is wrong with broken ones.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

constexpr char extension[] = "EXT_mesh_gpu_instancing";

Json instanced(const Json& attributes) { return {{extension, {{"attributes", attributes}}}}; }

/// A triangle with corners at x = 0, 1 and y = 1, drawn at x = 10, 20 and 30.
GltfBuilder three_copies(const Json& node = Json::object()) {
  GltfBuilder builder = one_triangle(Json::object(), node);
  const int translation = builder.positions<float>({10, 0, 0, 20, 0, 0, 30, 0, 0});
  builder.json["nodes"][0]["extensions"] = instanced({{"TRANSLATION", translation}});
  return builder;
}

Json& attributes_of(GltfBuilder& builder) {
  return builder.json["nodes"][0]["extensions"][extension]["attributes"];
}

const std::string place = "nodes[0].extensions.EXT_mesh_gpu_instancing";

TEST_CASE("a mesh is drawn once per instance, below the node's own map") {
  const Scene scene = three_copies({{"scale", {2, 2, 2}}}).load();
  REQUIRE(scene.triangles().size() == 3);
  REQUIRE(scene.vertices().size() == 9);
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = 20 * (static_cast<double>(i) + 1);
    CHECK(scene.corner(i, 0) == Vec3d{x, 0, 0});
    CHECK(scene.corner(i, 1) == Vec3d{x + 2, 0, 0});
  }
}

TEST_CASE("scale, rotation and translation of an instance are applied from right to left") {
  GltfBuilder builder = three_copies();
  // Half a turn about z; the same as a normalised byte or short; nothing.
  attributes_of(builder)["ROTATION"] =
      builder.accessor<float>("VEC4", 4, {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  attributes_of(builder)["SCALE"] = builder.positions<float>({1, 1, 1, 3, 4, 5, 3, 4, 5});
  const Scene scene = builder.load();
  CHECK(scene.corner(0, 1) == Vec3d{9, 0, 0});
  CHECK(scene.corner(1, 1) == Vec3d{17, 0, 0});
  CHECK(scene.corner(1, 2) == Vec3d{20, -4, 0});
  CHECK(scene.corner(2, 1) == Vec3d{33, 0, 0});
  const std::string hash = scene.hash();
  attributes_of(builder)["ROTATION"] =
      builder.normalized<std::int8_t>("VEC4", 4, {0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 0, 127});
  CHECK(builder.load().hash() == hash);
  attributes_of(builder)["ROTATION"] =
      builder.normalized<std::int16_t>("VEC4", 4, {0, 0, 32767, 0, 0, 0, 32767, 0, 0, 0, 0, 32767});
  CHECK(builder.load().hash() == hash);
}

TEST_CASE("the sign of each instance's own determinant decides its winding") {
  GltfBuilder builder = three_copies();
  attributes_of(builder)["SCALE"] = builder.positions<float>({1, 1, 1, -1, 1, 1, -1, -1, -1});
  CHECK(builder.load().triangles()[0] == Triangle{0, 1, 2});
  CHECK(builder.load().triangles()[1] == Triangle{3, 5, 4});
  CHECK(builder.load().triangles()[2] == Triangle{6, 8, 7});
  builder.json["nodes"][0]["scale"] = {1, -1, 1};
  CHECK(builder.load().triangles()[0] == Triangle{0, 2, 1});
  CHECK(builder.load().triangles()[1] == Triangle{3, 4, 5});
}

TEST_CASE("all primitives of one instance come before the next, and ids lead back to it") {
  GltfBuilder builder = three_copies();
  Json& primitives = builder.json["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  builder.root({{"mesh", 0}});
  const Scene scene = builder.load();
  REQUIRE(scene.sources().size() == 8);
  for (int i = 0; i < 6; ++i) {
    const SourceRange& source = scene.sources()[static_cast<std::size_t>(i)];
    CHECK((source.node == 0 && source.instance == i / 2 && source.primitive == i % 2));
    CHECK(scene.corner(source.first, 0).x == 10 * (i / 2 + 1));
  }
  CHECK(scene.sources()[6].instance == -1);
}

TEST_CASE("attributes of applications count instances too") {
  GltfBuilder builder = one_triangle();
  const int ids = builder.indices<std::uint8_t>({4, 5, 6, 7});
  builder.json["nodes"][0]["extensions"] = instanced({{"_ID", ids}});
  CHECK(builder.load().triangles().size() == 4);
  attributes_of(builder)["SCALE"] = builder.positions<float>({1, 1, 1});
  CHECK_FAILURE(builder.failure(), 2, place);
}

TEST_CASE("a node without a mesh has no instances") {
  GltfBuilder builder = three_copies();
  builder.json["nodes"][0].erase("mesh");
  CHECK(builder.load().primitive_count() == 0);
}

TEST_CASE("lines and points are counted once per instance") {
  GltfBuilder builder = three_copies();
  builder.json["meshes"][0]["primitives"][0]["mode"] = 3;
  CHECK(builder.load().skipped().lines == 6);
  builder.json["meshes"][0]["primitives"][0]["mode"] = 0;
  CHECK(builder.load().skipped().points == 9);
}

TEST_CASE("instances of a morphed mesh are morphed") {
  GltfBuilder builder = three_copies({{"weights", {2}}});
  builder.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", builder.positions<float>({0, 0, 3, 0, 0, 0, 0, 0, 0})}}};
  CHECK(builder.load().corner(2, 0) == Vec3d{30, 0, 6});
}

TEST_CASE("a file may require instances") {
  GltfBuilder builder = three_copies();
  builder.json["extensionsRequired"] = {extension};
  CHECK(builder.load().triangles().size() == 3);
}

TEST_CASE("instances of a skinned mesh are unsupported") {
  GltfBuilder builder = three_copies();
  builder.json["nodes"][0]["skin"] = 0;
  builder.json["skins"] = {{{"joints", {0}}}};
  CHECK_FAILURE(builder.failure(), 3, "nodes[0]");
}

TEST_CASE("broken attributes are errors that name them") {
  GltfBuilder builder = three_copies();
  attributes_of(builder)["ROTATION"] = builder.accessor<float>("VEC4", 4, {0, 0, 0, 1});
  CHECK_FAILURE(builder.failure(), 2, place);
  attributes_of(builder) = {{"TRANSLATION", 44}};
  CHECK_FAILURE(builder.failure(), 2, place + ".attributes.TRANSLATION");
  attributes_of(builder) = {{"TRANSLATION", "1"}};
  CHECK_FAILURE(builder.failure(), 2, place + ".attributes.TRANSLATION");
  attributes_of(builder) = Json::object();
  CHECK_FAILURE(builder.failure(), 2, place);
  builder.json["nodes"][0]["extensions"][extension] = Json::object();
  CHECK_FAILURE(builder.failure(), 2, place);
  builder = three_copies();
  attributes_of(builder)["TRANSLATION"] = builder.positions<std::int16_t>({1, 0, 0, 2, 0, 0, 3, 0, 0});
  CHECK_FAILURE(builder.failure(), 2, "accessors[2]");
  builder = three_copies();
  attributes_of(builder)["ROTATION"] =
      builder.accessor<std::int8_t>("VEC4", 4, {0, 0, 127, 0, 0, 0, 127, 0, 0, 0, 0, 127});
  CHECK_FAILURE(builder.failure(), 2, "accessors[2]");
}

TEST_CASE("an instance that overflows is an error that names it") {
  GltfBuilder builder = three_copies({{"scale", {1e300, 1, 1}}});
  attributes_of(builder)["SCALE"] = builder.positions<float>({1, 1, 1, 1e38f, 1, 1, 1, 1, 1});
  const Failure failure = builder.failure();
  CHECK_FAILURE(failure, 2, "nodes[0]");
  CHECK_THAT(failure.message, Catch::Contains("instance 1"));
}

TEST_CASE("more copies than there are ids are refused before memory is taken") {
  // 60 000 zeros cost no bytes of the file; eight primitives of as many vertices, as often, are over 2^32.
  GltfBuilder builder;
  const Json zeros = {{"componentType", 5126}, {"count", 60'000}, {"type", "VEC3"}};
  const int many = builder.add("accessors", zeros);
  builder.root({{"mesh", builder.mesh(many)}, {"extensions", instanced({{"TRANSLATION", many}})}});
  Json& primitives = builder.json["meshes"][0]["primitives"];
  for (int i = 0; i < 7; ++i) primitives.push_back(primitives[0]);
  CHECK_FAILURE(builder.failure(), 3, "scene");
}

TEST_CASE("a few bytes make no billions of vertices") {
  // Found by a fuzzer: zeros as often as zeros, fewer than there are ids, and 103 GB.
  const auto zeros_times_zeros = [](int count) {
    GltfBuilder builder;
    const int many = builder.add("accessors", {{"componentType", 5126}, {"count", count}, {"type", "VEC3"}});
    builder.root({{"mesh", builder.mesh(many)}, {"extensions", instanced({{"TRANSLATION", many}})}});
    return builder;
  };
  CHECK_FAILURE(zeros_times_zeros(65'535).failure(), 3, "scene");
  CHECK_THAT(zeros_times_zeros(65'535).failure().message, Catch::Contains("2048 vertices for each byte"));
  CHECK(zeros_times_zeros(300).load().vertices().size() == 90'000);
}

}  // namespace
}  // namespace provis
