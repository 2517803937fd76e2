// Points as spheres: radii, placement, flags, ids, and what is wrong with broken ones.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

/// Points at x = 0, 1 and 2.
GltfBuilder three_points(const Json& node = Json::object(), Json primitive = Json::object()) {
  GltfBuilder builder;
  primitive["mode"] = 0;
  Json placing = node;
  placing["mesh"] = builder.mesh(builder.positions(numbered_positions(3)), primitive);
  builder.root(placing);
  return builder;
}

Json& attributes_of(GltfBuilder& builder) { return builder.json["meshes"][0]["primitives"][0]["attributes"]; }

/// The same points with radii 1, 2 and 0.
GltfBuilder three_spheres(const Json& node = Json::object(), const Json& primitive = Json::object()) {
  GltfBuilder builder = three_points(node, primitive);
  attributes_of(builder)["_RADIUS"] = builder.indices<float>({1, 2, 0});
  return builder;
}

LoadOptions with_radius(double radius) {
  LoadOptions options;
  options.radius = radius;
  return options;
}

TEST_CASE("points with radii are spheres and add no vertices") {
  const Scene scene = three_spheres().load();
  REQUIRE(scene.spheres().size() == 3);
  CHECK((scene.vertices().empty() && scene.triangles().empty() && scene.skipped().points == 0));
  CHECK((scene.spheres()[1].center == Vec3d{1, 0, 0} && scene.spheres()[1].radius == 2));
  CHECK(scene.spheres()[2].radius == 0);
}

TEST_CASE("points without radii are counted, unless all get one") {
  CHECK(three_points().load().skipped().points == 3);
  CHECK(three_points().load().spheres().empty());
  const Scene scene = three_points().load(with_radius(0.25));
  REQUIRE(scene.spheres().size() == 3);
  CHECK((scene.spheres()[2].radius == 0.25 && scene.skipped().points == 0));
  CHECK(three_spheres().load(with_radius(0.25)).spheres()[1].radius == 2);
}

TEST_CASE("indices name the points, as often as they like") {
  GltfBuilder builder = three_spheres();
  builder.json["meshes"][0]["primitives"][0]["indices"] = builder.indices<std::uint8_t>({1, 0, 1, 1});
  const Scene scene = builder.load();
  REQUIRE(scene.spheres().size() == 4);
  CHECK((scene.spheres()[0].center.x == 1 && scene.spheres()[1].center.x == 0));
  CHECK((scene.spheres()[3].center.x == 1 && scene.spheres()[3].radius == 2));
}

TEST_CASE("the node's map moves centers and scales radii of the file, not those of the option") {
  const Json node = {{"translation", {0, 5, 0}}, {"rotation", {0, 0, 1, 0}}, {"scale", {3, 3, 3}}};
  const Scene scene = three_spheres(node).load();
  CHECK((scene.spheres()[1].center == Vec3d{-3, 5, 0} && scene.spheres()[1].radius == 6));
  CHECK(three_points(node).load(with_radius(0.5)).spheres()[1].radius == 0.5);
  CHECK(three_spheres({{"scale", {-3, 3, 3}}}).load().spheres()[1].radius == 6);
  CHECK(three_spheres({{"scale", {0, 0, 0}}}).load().spheres()[1].radius == 0);
  // The first column's length, as computed.
  const double w = double{0.9f}, z = double{0.43f}, c = 1 - 2 * (z * z), s = 2 * (z * w);
  CHECK(three_spheres({{"rotation", {0, 0, z, w}}, {"scale", {1, 1, c * c + s * s}}}).failure().status == 3);
  const double length = std::sqrt(c * c + s * s);
  CHECK(three_spheres({{"rotation", {0, 0, z, w}}, {"scale", {1, 1, length}}}).load().spheres()[1].radius ==
        2 * length);
}

TEST_CASE("maps that make ellipsoids are unsupported, unless the radius is the option's") {
  CHECK_FAILURE(three_spheres({{"scale", {1, 1, 2}}}).failure(), 3, "nodes[0]");
  const Json sheared = {{"matrix", {1, 0, 0, 0, 0.6, 0.8, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
  CHECK_FAILURE(three_spheres(sheared).failure(), 3, "nodes[0]");
  CHECK(three_points(sheared).load(with_radius(1)).spheres().size() == 3);
  // Squared lengths may differ by 2^-20 of the largest, as rotations in float32 do.
  CHECK(three_spheres({{"scale", {1, 1, 1 + 0x1p-22}}}).load().spheres().size() == 3);
  CHECK_FAILURE(three_spheres({{"scale", {1, 1, 1 + 0x1p-20}}}).failure(), 3, "nodes[0]");
}

TEST_CASE("spheres have the flags of their material") {
  CHECK(three_spheres().load().sphere_flags()[0] == single_sided);
  GltfBuilder builder = three_spheres(Json::object(), {{"material", 0}});
  builder.json["materials"] = {{{"doubleSided", true}}};
  CHECK(builder.load().sphere_flags()[0] == 0);
  builder.json["materials"] = {{{"alphaMode", "BLEND"}}};
  CHECK(builder.load().sphere_flags()[2] == (single_sided | see_through));
  CHECK(builder.load({Sides::both, Opacity::all}).sphere_flags()[2] == 0);
}

TEST_CASE("spheres come after all triangles, and so do their sources") {
  GltfBuilder builder = three_spheres({{"name", "first"}});
  Json& primitives = builder.json["meshes"][0]["primitives"];
  primitives.push_back({{"attributes", primitives[0]["attributes"]}});
  builder.root({{"mesh", 0}, {"translation", {0, 0, 9}}});
  const Scene scene = builder.load();
  REQUIRE((scene.triangles().size() == 2 && scene.spheres().size() == 6));
  REQUIRE(scene.sources().size() == 4);
  const SourceRange triangles = scene.sources()[1], spheres = scene.sources()[3];
  CHECK((triangles.first == 1 && triangles.count == 1 && triangles.node == 1 && triangles.primitive == 1));
  CHECK((spheres.first == 5 && spheres.count == 3 && spheres.node == 1 && spheres.primitive == 0));
  CHECK(scene.sources()[2].first == 2);
  CHECK(scene.spheres()[3].center == Vec3d{0, 0, 9});
}

TEST_CASE("radii may be integers, normalised or not") {
  GltfBuilder builder = three_spheres();
  attributes_of(builder)["_RADIUS"] = builder.normalized<std::uint8_t>("SCALAR", 1, {51, 255, 0});
  CHECK(builder.load().spheres()[0].radius == 51.0 / 255);
  attributes_of(builder)["_RADIUS"] = builder.indices<std::uint16_t>({51, 255, 0});
  CHECK(builder.load().spheres()[0].radius == 51);
}

TEST_CASE("broken radii are errors that name accessor and element") {
  GltfBuilder builder = three_spheres();
  attributes_of(builder)["_RADIUS"] = builder.indices<float>({1, 1, -0.5f});
  Failure failure = builder.failure();
  CHECK_FAILURE(failure, 2, "accessors[2]");
  CHECK_THAT(failure.message, Catch::Contains("element 2"));
  attributes_of(builder)["_RADIUS"] = builder.indices<float>({1, std::numeric_limits<float>::quiet_NaN(), 1});
  failure = builder.failure();
  CHECK_FAILURE(failure, 2, "accessors[3]");
  CHECK_THAT(failure.message, Catch::Contains("element 1"));
  attributes_of(builder)["_RADIUS"] = builder.indices<float>({1, 1});
  CHECK_FAILURE(builder.failure(), 2, "accessors[4]");
  attributes_of(builder)["_RADIUS"] = 0;
  CHECK_FAILURE(builder.failure(), 2, "accessors[0]");
  attributes_of(builder)["_RADIUS"] = 77;
  CHECK_FAILURE(builder.failure(), 2, "meshes[0].primitives[0].attributes._RADIUS");
  CHECK_FAILURE(three_spheres({{"scale", {1e200, 1e200, 1e200}}}).failure(), 2, "nodes[0]");
}

TEST_CASE("a radius that is no length is a usage error") {
  for (const double radius : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    CHECK_FAILURE(three_points().failure(with_radius(radius)), 1, "--radius");
}

TEST_CASE("radii of triangles and lines mean nothing") {
  GltfBuilder builder = three_spheres();
  builder.json["meshes"][0]["primitives"][0]["mode"] = 3;
  CHECK(builder.load(with_radius(1)).skipped().lines == 2);
  builder.json["meshes"][0]["primitives"][0]["mode"] = 4;
  CHECK(builder.load(with_radius(1)).spheres().empty());
}

TEST_CASE("spheres can be morphed, animated and instanced") {
  GltfBuilder builder = three_spheres({{"weights", {2}}});
  builder.json["meshes"][0]["primitives"][0]["targets"] = {
      {{"POSITION", builder.positions<float>({0, 0, 3, 0, 0, 0, 0, 0, 0})}}};
  CHECK(builder.load().spheres()[0].center == Vec3d{0, 0, 6});

  const int input = builder.indices<float>({0, 1}), output = builder.positions<float>({1, 1, 1, 3, 3, 3});
  builder.add("animations", {{"samplers", {{{"input", input}, {"output", output}}}},
                             {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "scale"}}}}}}});
  LoadOptions options;
  options.time = 0.5;
  CHECK((builder.load(options).spheres()[0].center == Vec3d{0, 0, 12} &&
         builder.load(options).spheres()[0].radius == 2));

  const int scale = builder.positions<float>({1, 1, 1, 5, 5, 5});
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"SCALE", scale}};
  const Scene scene = builder.load();
  REQUIRE(scene.spheres().size() == 6);
  CHECK((scene.spheres()[4].center == Vec3d{5, 0, 0} && scene.spheres()[4].radius == 10));
  CHECK(scene.sources()[1].instance == 1);
}

TEST_CASE("centers of skinned spheres follow their joints, radii their vertex's map") {
  GltfBuilder builder = three_spheres({{"skin", 0}, {"scale", {7, 8, 9}}});
  attributes_of(builder)["JOINTS_0"] =
      builder.accessor<std::uint8_t>("VEC4", 4, {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
  attributes_of(builder)["WEIGHTS_0"] =
      builder.accessor<float>("VEC4", 4, {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0});
  builder.root({{"translation", {0, 10, 0}}});
  builder.root({{"scale", {3, 3, 3}}});
  builder.add("skins", {{"joints", {1, 2}}});
  const Scene scene = builder.load();
  CHECK((scene.spheres()[0].center == Vec3d{0, 10, 0} && scene.spheres()[0].radius == 1));
  CHECK((scene.spheres()[1].center == Vec3d{3, 0, 0} && scene.spheres()[1].radius == 6));
  CHECK(scene.spheres()[2].center == Vec3d{4, 5, 0});
}

TEST_CASE("an exported scene of spheres and triangles keeps its hash") {
  GltfBuilder builder = three_spheres();
  Json& primitives = builder.json["meshes"][0]["primitives"];
  primitives.push_back({{"attributes", primitives[0]["attributes"]}});
  const Scene scene = builder.load();
  const TempFolder folder;
  export_ply(scene, folder.path() / "x.ply");
  CHECK(load_scene(folder.path() / "x.ply").hash() == scene.hash());
}

}  // namespace
}  // namespace provis
