// Skinned vertices: joints, inverse bind matrices, all sets of influences, and what is wrong with broken
// ones.
#include <catch2/catch.hpp>
#include <limits>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

/// Column by column: a translation.
std::vector<float> moved(float x, float y, float z) {
  return {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1};
}

std::vector<float> joined(const std::vector<std::vector<float>>& parts) {
  std::vector<float> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

/// Node 0 places a triangle with skin 0, whose joints are node 1 at x = 10 and its child, node 2, 100 above
/// it. Vertex 0 follows the first joint, vertex 1 the second, vertex 2 the first by a quarter.
struct Skinned : GltfBuilder {
  int joints = -1, weights = -1;

  explicit Skinned(const Json& node = Json::object()) {
    const int positions_accessor = positions<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
    joints = accessor<std::uint8_t>("VEC4", 4, {0, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    weights = accessor<float>("VEC4", 4, {1, 0, 0, 0, 0, 1, 0, 0, 0.25f, 0.75f, 0, 0});
    mesh(positions_accessor, {{"attributes", {{"JOINTS_0", joints}, {"WEIGHTS_0", weights}}}});
    Json placing = node;
    placing["mesh"] = 0;
    placing["skin"] = 0;
    root(placing);
    root({{"translation", {10, 0, 0}}, {"children", {2}}});
    add("nodes", {{"translation", {0, 100, 0}}});
    add("skins", {{"joints", {1, 2}}});
  }

  Json& primitive() { return json["meshes"][0]["primitives"][0]; }
};

TEST_CASE("vertices follow the weighted maps of nested joints") {
  const Scene scene = Skinned().load();
  CHECK(scene.vertices()[0] == Vec3d{10, 0, 0});
  CHECK(scene.vertices()[1] == Vec3d{11, 100, 0});
  CHECK(scene.vertices()[2] == Vec3d{10, 76, 0});
  CHECK(scene.sources()[0].node == 0);
}

TEST_CASE("inverse bind matrices come before the joints") {
  Skinned builder;
  builder.json["nodes"][1]["scale"] = {2, 2, 2};
  const int matrices =
      builder.accessor("MAT4", 16, joined({moved(-1, 0, 0), moved(0, -50, 0), moved(7, 7, 7)}));
  builder.json["skins"][0]["inverseBindMatrices"] = matrices;
  const Scene scene = builder.load();
  CHECK(scene.vertices()[0] == Vec3d{8, 0, 0});
  CHECK(scene.vertices()[1] == Vec3d{12, 100, 0});
  // A quarter of (8, 2, 0) and three quarters of (10, 102, 0).
  CHECK(scene.vertices()[2] == Vec3d{9.5, 77, 0});
}

TEST_CASE("the node of a skinned mesh moves nothing, but a mirroring one turns the winding round") {
  const Json far = {{"translation", {1000, 1000, 1000}}, {"scale", {3, 3, 3}}};
  CHECK(Skinned(far).load().hash() == Skinned().load().hash());
  const Json mirror = {{"scale", {-1, 1, 1}}};
  const Scene mirrored = Skinned(mirror).load();
  CHECK(mirrored.vertices()[1] == Vec3d{11, 100, 0});
  CHECK(mirrored.triangles()[0] == Triangle{0, 2, 1});
  Skinned joint;
  joint.json["nodes"][1]["scale"] = {-1, 1, 1};
  CHECK(joint.load().triangles()[0] == Triangle{0, 1, 2});
}

TEST_CASE("joints need not belong to the scene") {
  Skinned builder;
  builder.json["scenes"] = {{{"nodes", {0}}}};
  CHECK(builder.load().vertices()[1] == Vec3d{11, 100, 0});
}

TEST_CASE("a skin may be animated by its joints") {
  Skinned builder;
  const int input = builder.indices<float>({0, 1});
  const int output = builder.accessor<float>("VEC3", 3, {0, 0, 0, 0, 0, 8});
  builder.add("animations",
              {{"samplers", {{{"input", input}, {"output", output}}}},
               {"channels", {{{"sampler", 0}, {"target", {{"node", 2}, {"path", "translation"}}}}}}});
  LoadOptions options;
  options.time = 0.5;
  CHECK(builder.load(options).vertices()[1] == Vec3d{11, 0, 4});
}

TEST_CASE("two nodes may place one mesh with different skins or none") {
  Skinned builder;
  builder.add("skins", {{"joints", {2, 1}}});
  builder.root({{"mesh", 0}, {"skin", 1}});
  builder.root({{"mesh", 0}, {"translation", {0, 0, 5}}});
  const Scene scene = builder.load();
  REQUIRE(scene.vertices().size() == 9);
  CHECK(scene.vertices()[3] == Vec3d{10, 100, 0});
  CHECK(scene.vertices()[6] == Vec3d{0, 0, 5});
}

TEST_CASE("all sets of influences count") {
  Skinned builder;
  const int more = builder.accessor<std::uint16_t>("VEC4", 4, {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  const int weights = builder.accessor<float>("VEC4", 4, {0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0});
  builder.primitive()["attributes"]["JOINTS_1"] = more;
  builder.primitive()["attributes"]["WEIGHTS_1"] = weights;
  // Weights are never normalised: vertex 0 has 1 of each joint.
  CHECK(builder.load().vertices()[0] == Vec3d{20, 100, 0});
  CHECK(builder.load().vertices()[1] == Vec3d{11, 100, 0});
}

TEST_CASE("weights may be normalised integers, and a vertex without any lies at the origin") {
  Skinned builder;
  builder.primitive()["attributes"]["WEIGHTS_0"] =
      builder.normalized<std::uint8_t>("VEC4", 4, {255, 0, 0, 0, 0, 255, 0, 0, 0, 0, 0, 0});
  CHECK(builder.load().vertices()[0] == Vec3d{10, 0, 0});
  CHECK(builder.load().vertices()[2] == Vec3d{0, 0, 0});
  builder.primitive()["attributes"]["WEIGHTS_0"] =
      builder.normalized<std::uint16_t>("VEC4", 4, {65535, 0, 0, 0, 0, 65535, 0, 0, 0, 13107, 0, 0});
  CHECK(builder.load().vertices()[2].x == 10 * (13107.0 / 65535));
}

TEST_CASE("morph targets come before the skin") {
  Skinned builder;
  builder.json["nodes"][1]["scale"] = {2, 2, 2};
  builder.primitive()["targets"] = {{{"POSITION", builder.positions<float>({0, 0, 1, 0, 0, 0, 0, 0, 0})}}};
  builder.json["meshes"][0]["weights"] = {3};
  CHECK(builder.load().vertices()[0] == Vec3d{10, 0, 6});
}

TEST_CASE("a joint out of range is an error where it has a weight, naming the element") {
  Skinned builder;
  builder.primitive()["attributes"]["JOINTS_0"] =
      builder.accessor<std::uint8_t>("VEC4", 4, {0, 0, 0, 200, 0, 1, 0, 0, 0, 1, 0, 0});
  CHECK(builder.load().vertices()[0] == Vec3d{10, 0, 0});
  builder.primitive()["attributes"]["JOINTS_0"] =
      builder.accessor<std::uint8_t>("VEC4", 4, {0, 0, 0, 0, 0, 2, 0, 0, 0, 1, 0, 0});
  const Failure failure = builder.failure();
  CHECK_FAILURE(failure, 2, "meshes[0].primitives[0]");
  CHECK_THAT(failure.message, Catch::Contains("accessors[4]: element 1 names joint 2 of 2"));
}

TEST_CASE("attributes of a skinned primitive must be there, complete and of their types") {
  const std::string place = "meshes[0].primitives[0]";
  Skinned builder;
  builder.primitive()["attributes"].erase("WEIGHTS_0");
  CHECK_FAILURE(builder.failure(), 2, place);
  builder.primitive()["attributes"].erase("JOINTS_0");
  CHECK_FAILURE(builder.failure(), 2, place);
  builder = Skinned();
  builder.primitive()["attributes"]["JOINTS_2"] = builder.joints;
  CHECK_FAILURE(builder.failure(), 2, place);
  builder = Skinned();
  builder.primitive()["attributes"]["JOINTS_0"] = builder.accessor<std::uint8_t>("VEC4", 4, {0, 0, 0, 0});
  CHECK_FAILURE(builder.failure(), 2, place);
  builder = Skinned();
  builder.json["accessors"][builder.joints]["type"] = "VEC3";
  CHECK_FAILURE(builder.failure(), 2, "accessors[1]");
  builder = Skinned();
  builder.json["accessors"][builder.joints]["normalized"] = true;
  CHECK_FAILURE(builder.failure(), 2, "accessors[1]");
  builder = Skinned();
  builder.primitive()["attributes"]["WEIGHTS_0"] = builder.joints;
  CHECK_FAILURE(builder.failure(), 2, "accessors[1]");
}

TEST_CASE("weights that are not finite are an error") {
  Skinned builder;
  const float infinity = std::numeric_limits<float>::infinity();
  builder.primitive()["attributes"]["WEIGHTS_0"] =
      builder.accessor<float>("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 1, infinity, 0, 0});
  const Failure failure = builder.failure();
  CHECK_FAILURE(failure, 2, "accessors[3]");
  CHECK_THAT(failure.message, Catch::Contains("element 2"));
}

TEST_CASE("a broken skin is an error that names it") {
  Skinned builder;
  builder.json["nodes"][0]["skin"] = 1;
  CHECK_FAILURE(builder.failure(), 2, "nodes[0]");
  builder = Skinned();
  builder.json["skins"][0]["joints"] = {1, 9};
  CHECK_FAILURE(builder.failure(), 2, "skins[0].joints[1]");
  builder.json["skins"][0]["joints"] = {1, "2"};
  CHECK_FAILURE(builder.failure(), 2, "skins[0].joints[1]");
  builder.json["skins"][0].erase("joints");
  CHECK_FAILURE(builder.failure(), 2, "skins[0]");
  builder = Skinned();
  builder.json["skins"][0]["inverseBindMatrices"] = 9;
  CHECK_FAILURE(builder.failure(), 2, "skins[0].inverseBindMatrices");
  builder.json["skins"][0]["inverseBindMatrices"] = builder.accessor("MAT4", 16, moved(0, 0, 0));
  CHECK_FAILURE(builder.failure(), 2, "skins[0]");
  std::vector<float> perspective = joined({moved(0, 0, 0), moved(0, 0, 0)});
  perspective[16 + 3] = 0.5f;
  builder.json["skins"][0]["inverseBindMatrices"] = builder.accessor("MAT4", 16, perspective);
  const Failure failure = builder.failure();
  CHECK_FAILURE(failure, 2, "accessors[4]");
  CHECK_THAT(failure.message, Catch::Contains("element 1"));
  builder.json["accessors"].back()["type"] = "VEC4";
  CHECK_FAILURE(builder.failure(), 2, "accessors[4]");
}

TEST_CASE("a skin that skins nothing may be broken") {
  Skinned builder;
  builder.json["skins"].push_back("broken");
  builder.json["skins"].push_back({{"joints", {77}}, {"inverseBindMatrices", 88}});
  builder.root({{"skin", 1}});
  CHECK(builder.load().triangles().size() == 1);
  builder.json["nodes"].back()["mesh"] = 0;
  CHECK_FAILURE(builder.failure(), 2, "skins[1]");
  builder.json["nodes"].back()["skin"] = 2;
  CHECK_FAILURE(builder.failure(), 2, "skins[2].inverseBindMatrices");
}

TEST_CASE("joints that overflow are an error that names them") {
  Skinned builder;
  builder.json["nodes"][1]["scale"] = {1e200, 1, 1};
  builder.json["nodes"][2]["scale"] = {1e200, 1, 1};
  CHECK_FAILURE(builder.failure(), 2, "nodes[2]");
}

}  // namespace
}  // namespace provis
