// Morph targets: whose weights count, displacements of every kind, and what is wrong with broken ones.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

/// A triangle whose first vertex two targets pull along x and y.
GltfBuilder two_targets(const Json& node = Json::object(), const Json& mesh_weights = nullptr) {
  GltfBuilder builder;
  const int base = builder.positions<float>({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const int x = builder.positions<float>({1, 0, 0, 0, 0, 0, 0, 0, 0});
  const int y = builder.positions<float>({0, 1, 0, 0, 0, 2, 0, 0, 0});
  Json placing = node;
  placing["mesh"] = builder.mesh(base, {{"targets", {{{"POSITION", x}}, {{"POSITION", y}}}}});
  if (!mesh_weights.is_null()) builder.json["meshes"][0]["weights"] = mesh_weights;
  builder.root(placing);
  return builder;
}

Vec3d first_vertex(const GltfBuilder& builder) { return builder.load().vertices()[0]; }

TEST_CASE("weights are the node's, else the mesh's, else zero") {
  CHECK(first_vertex(two_targets()) == Vec3d{0, 0, 0});
  CHECK(first_vertex(two_targets(Json::object(), {0.5, 2})) == Vec3d{0.5, 2, 0});
  CHECK(first_vertex(two_targets({{"weights", {-1, 0.25}}}, {0.5, 2})) == Vec3d{-1, 0.25, 0});
  CHECK(two_targets(Json::object(), {0, 2}).load().vertices()[1] == Vec3d{1, 0, 4});
}

TEST_CASE("the node's map comes after its targets, and each node has its own weights") {
  GltfBuilder builder = two_targets({{"weights", {1, 0}}, {"scale", {10, 10, 10}}});
  builder.root({{"mesh", 0}, {"weights", {0, 1}}});
  builder.root({{"mesh", 0}});
  const Scene scene = builder.load();
  CHECK(scene.vertices()[0] == Vec3d{10, 0, 0});
  CHECK(scene.vertices()[3] == Vec3d{0, 1, 0});
  CHECK(scene.vertices()[6] == Vec3d{0, 0, 0});
}

TEST_CASE("displacements are added one after the other, without fused operations") {
  const double w0 = 1.0 / 3, w1 = 0.1;
  GltfBuilder builder = two_targets({{"weights", {w0, w1}}});
  builder.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", builder.positions<float>({0.7f, 0, 0, 0, 0, 0, 0, 0, 0})}},
      {{"POSITION", builder.positions<float>({-0.9f, 0, 0, 0, 0, 0, 0, 0, 0})}}};
  builder.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] =
      builder.positions<float>({0.3f, 0, 0, 0, 0, 0, 0, 0, 0});
  volatile double first = w0 * double{0.7f}, second = w1 * double{-0.9f}, sum = double{0.3f};
  sum = sum + first;
  sum = sum + second;
  CHECK(first_vertex(builder).x == sum);
}

TEST_CASE("animated weights win, all targets at one key side by side") {
  GltfBuilder builder = two_targets({{"weights", {9, 9}}});
  const int input = builder.indices<float>({0, 2});
  const int linear = builder.indices<float>({0, 1, 4, 3});
  // In-tangents, values, out-tangents of both targets for each key.
  const int spline = builder.indices<float>({9, 9, 0, 1, 8, 0, 0, 0, 4, 3, 9, 9});
  for (const auto& [output, interpolation] : {std::pair{linear, "LINEAR"}, std::pair{spline, "CUBICSPLINE"}})
    builder.add("animations",
                {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
  LoadOptions options;
  options.time = 0.5;
  CHECK(builder.load(options).vertices()[0] == Vec3d{1, 1.5, 0});
  options.animation = "1";
  options.time = 1;
  // 4/2 + 2 * 8 * (1/8 - 2/4 + 1/2) and 1/2 + 3/2.
  CHECK(builder.load(options).vertices()[0] == Vec3d{4, 2, 0});
  options.time = 2;
  CHECK(builder.load(options).vertices()[0] == Vec3d{4, 3, 0});
}

TEST_CASE("animated weights must be as many as there are targets") {
  GltfBuilder builder = two_targets();
  const int input = builder.indices<float>({0, 2}), output = builder.indices<float>({0, 1, 2});
  builder.add("animations",
              {{"samplers", {{{"input", input}, {"output", output}}}},
               {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}}}});
  LoadOptions options;
  options.time = 0.5;
  CHECK_FAILURE(builder.failure(options), 2, "animations[0].samplers[0]");
}

TEST_CASE("displacements may be quantised, normalised or sparse") {
  GltfBuilder builder = two_targets({{"weights", {2, 1}}});
  Json& targets = builder.json["meshes"][0]["primitives"][0]["targets"];
  targets[0]["POSITION"] = builder.positions<std::int8_t>({-3, 4, 0, 0, 0, 0, 0, 0, 0});
  targets[1]["POSITION"] = builder.normalized<std::int16_t>("VEC3", 3, {32767, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(first_vertex(builder) == Vec3d{-5, 8, 0});

  const int target = builder.view<std::uint8_t>({2}), value = builder.view<float>({0, 0, 7});
  targets[0]["POSITION"] =
      builder.add("accessors", {{"componentType", 5126},
                                {"count", 3},
                                {"type", "VEC3"},
                                {"sparse",
                                 {{"count", 1},
                                  {"indices", {{"bufferView", target}, {"componentType", 5121}}},
                                  {"values", {{"bufferView", value}}}}}});
  CHECK(builder.load().vertices()[2] == Vec3d{0, 1, 14});
  CHECK(builder.load().vertices()[0] == Vec3d{1, 0, 0});
}

TEST_CASE("targets of weight 0 may be broken, targets without positions displace nothing") {
  GltfBuilder builder = two_targets({{"weights", {0, 1}}});
  Json& targets = builder.json["meshes"][0]["primitives"][0]["targets"];
  targets[0]["POSITION"] = 77;
  CHECK(first_vertex(builder) == Vec3d{0, 1, 0});
  targets[1] = {{"NORMAL", 0}};
  CHECK(first_vertex(builder) == Vec3d{0, 0, 0});
}

TEST_CASE("every primitive of the mesh has its own targets") {
  GltfBuilder builder = two_targets({{"weights", {1, 1}}});
  Json second = builder.json["meshes"][0]["primitives"][0];
  second["targets"] = {second["targets"][1], second["targets"][1]};
  builder.json["meshes"][0]["primitives"].push_back(second);
  const Scene scene = builder.load();
  CHECK(scene.vertices()[0] == Vec3d{1, 1, 0});
  CHECK(scene.vertices()[3] == Vec3d{0, 2, 0});
}

TEST_CASE("numbers of weights and displacements must agree") {
  const std::string place = "meshes[0].primitives[0]";
  CHECK_FAILURE(two_targets({{"weights", {1}}}).failure(), 2, place);
  CHECK_FAILURE(two_targets({{"weights", {1, 1, 0}}}).failure(), 2, place);
  CHECK_FAILURE(two_targets(Json::object(), {1}).failure(), 2, place);
  CHECK_FAILURE(one_triangle(Json::object(), {{"weights", {1}}}).failure(), 2, place);
  GltfBuilder builder = two_targets({{"weights", {1, 1}}});
  Json& target = builder.json["meshes"][0]["primitives"][0]["targets"][1]["POSITION"];
  target = builder.positions<float>({0, 0, 0});
  CHECK_FAILURE(builder.failure(), 2, place + ".targets[1]");
  target = 99;
  CHECK_FAILURE(builder.failure(), 2, place + ".targets[1]");
  target = "2";
  CHECK_FAILURE(builder.failure(), 2, place + ".targets[1].POSITION");
}

TEST_CASE("a displacement that leaves the range of numbers is an error that names the vertex") {
  GltfBuilder builder = two_targets({{"weights", {1e308, 0}}});
  Json& target = builder.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"];
  target = builder.positions<float>({3e38f, 0, 0, 0, 0, 0, 0, 0, 0});
  const Failure failure = builder.failure();
  CHECK_FAILURE(failure, 2, "nodes[0]");
  CHECK_THAT(failure.message, Catch::Contains("vertex 0"));
}

}  // namespace
}  // namespace provis
