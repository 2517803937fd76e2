// Hierarchy, placement, winding under mirroring, ids and source ranges.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

const std::vector<float> triangle_coordinates = {0, 0, 0, 1, 0, 0, 0, 1, 0};

std::array<Vec3d, 3> corners(const Scene& scene, std::size_t t = 0) {
  return {scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)};
}

Json scaled(double x, double y, double z) { return {{"scale", {x, y, z}}}; }

TEST_CASE("matrices are read column by column") {
  const Scene scene =
      one_triangle(Json::object(), {{"matrix", {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1}}}).load();
  CHECK(corners(scene) == std::array<Vec3d, 3>{{{5, 6, 7}, {7, 6, 7}, {5, 9, 7}}});
}

TEST_CASE("translation, rotation and scale are applied from right to left") {
  // A quarter turn about z: x goes to y. The quaternion is exact only without its normalisation.
  const Scene scene =
      one_triangle(Json::object(),
                   {{"translation", {10, 20, 30}}, {"rotation", {0, 0, 1, 0}}, {"scale", {2, 3, 1}}})
          .load();
  CHECK(corners(scene) == std::array<Vec3d, 3>{{{10, 20, 30}, {8, 20, 30}, {10, 17, 30}}});
}

TEST_CASE("quaternions are taken as stored") {
  // Twice the unit quaternion of no rotation changes nothing; (0, 0, 2, 0) gives 1 - 2*4 = -7.
  CHECK(corners(one_triangle(Json::object(), {{"rotation", {0, 0, 0, 2}}}).load())[1] == Vec3d{1, 0, 0});
  CHECK(corners(one_triangle(Json::object(), {{"rotation", {0, 0, 2, 0}}}).load())[1] == Vec3d{-7, 0, 0});
}

TEST_CASE("the global map is parent times local") {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions(triangle_coordinates));
  const int child = builder.add("nodes", {{"mesh", mesh}, {"translation", {1, 0, 0}}});
  builder.root({{"children", {child}}, {"scale", {2, 2, 2}}});
  CHECK(corners(builder.load()) == std::array<Vec3d, 3>{{{2, 0, 0}, {4, 0, 0}, {2, 2, 0}}});
}

TEST_CASE("coordinates are rounded in the documented order, without fused operations") {
  const double a = 0.1, b = 0.7, c = 1e-9, t = 1.0 / 3;
  GltfBuilder builder;
  builder.root({{"mesh", builder.mesh(builder.positions<float>({0.3f, 0.9f, -5.1f, 0, 0, 0, 0, 0, 0}))},
                {"matrix", {a, 0, 0, 0, b, 1, 0, 0, c, 0, 1, 0, t, 0, 0, 1}}});
  volatile double ax = a * double{0.3f}, by = b * double{0.9f}, cz = c * double{-5.1f};
  volatile double sum = ax + by;
  sum = sum + cz;
  CHECK(builder.load().vertices()[0].x == sum + t);
}

TEST_CASE("one mirrored level turns the winding round, two restore it") {
  CHECK(one_triangle(Json::object(), scaled(1, 1, 1)).load().triangles()[0] == Triangle{0, 1, 2});
  CHECK(one_triangle(Json::object(), scaled(-1, 1, 1)).load().triangles()[0] == Triangle{0, 2, 1});
  CHECK(one_triangle(Json::object(), scaled(-1, -1, 1)).load().triangles()[0] == Triangle{0, 1, 2});
  CHECK(one_triangle(Json::object(), scaled(-1, -1, -1)).load().triangles()[0] == Triangle{0, 2, 1});

  GltfBuilder builder;
  Json inner = scaled(1, -1, 1);
  inner["mesh"] = builder.mesh(builder.positions(triangle_coordinates));
  Json outer = scaled(1, 1, -1);
  outer["children"] = {builder.add("nodes", inner)};
  builder.root(outer);
  CHECK(builder.load().triangles()[0] == Triangle{0, 1, 2});
}

TEST_CASE("a determinant that underflows or is lost to rounding keeps its sign") {
  CHECK(one_triangle(Json::object(), scaled(-1e-200, 1e-200, 1e-200)).load().triangles()[0] ==
        Triangle{0, 2, 1});
  CHECK(one_triangle(Json::object(), scaled(0, -1, 1)).load().triangles()[0] == Triangle{0, 1, 2});
}

TEST_CASE("nodes come depth-first in file order, one copy of the vertices each") {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions(triangle_coordinates));
  const auto leaf = [&](double x) {
    return builder.add("nodes", {{"mesh", mesh}, {"translation", {x, 0, 0}}});
  };
  const int a = leaf(10), b = leaf(20), c = leaf(30);
  builder.root({{"children", {c, a}}, {"mesh", mesh}, {"name", "first"}});
  builder.root({{"children", {b}}});
  const Scene scene = builder.load();
  REQUIRE(scene.triangles().size() == 4);
  CHECK(scene.vertices().size() == 12);
  const double expected[] = {0, 30, 10, 20};
  for (std::size_t t = 0; t < 4; ++t) CHECK(scene.corner(t, 0).x == expected[t]);
  CHECK(scene.triangles()[3] == Triangle{9, 10, 11});
  CHECK(scene.node_names()[3] == "first");
}

TEST_CASE("source ranges lead from an id to node, mesh and primitive") {
  GltfBuilder builder;
  const int quad = builder.positions(numbered_positions(6)),
            triangle = builder.positions(triangle_coordinates);
  const int mesh = builder.mesh(quad);
  builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", quad}}}, {"mode", 1}});
  builder.json["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", triangle}}}});
  builder.add("nodes", {{"name", "unused"}});
  builder.root({{"mesh", mesh}});
  builder.root({{"mesh", mesh}});
  const Scene scene = builder.load();
  REQUIRE(scene.sources().size() == 4);
  const SourceRange last = scene.sources()[3];
  CHECK((last.first == 5 && last.count == 1 && last.node == 2 && last.mesh == 0 && last.primitive == 2));
  const SourceRange third = scene.sources()[2];
  CHECK((third.first == 3 && third.count == 2 && third.node == 2 && third.primitive == 0));
  CHECK(scene.skipped().lines == 6);
  CHECK(scene.vertices().size() == 18);
}

TEST_CASE("the default scene counts, else scene 0, else all roots") {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions(triangle_coordinates));
  for (const double x : {1.0, 2.0, 3.0}) builder.add("nodes", {{"mesh", mesh}, {"translation", {x, 0, 0}}});
  builder.json["nodes"][2]["children"] = {0};
  CHECK(builder.load().triangles().size() == 3);
  CHECK(builder.load().corner(0, 0).x == 2);
  CHECK(builder.load().corner(2, 0).x == 4);
  builder.json["scenes"] = {{{"nodes", {1}}}, {{"nodes", {2}}}};
  CHECK(builder.load().triangles().size() == 1);
  CHECK(builder.load().corner(0, 0).x == 2);
  builder.json["scene"] = 1;
  CHECK(builder.load().triangles().size() == 2);
  builder.json["scene"] = 2;
  CHECK_FAILURE(builder.failure(), 2, "scene");
}

TEST_CASE("the scene that is asked for wins over the default, which may then be broken") {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions(triangle_coordinates));
  for (const double x : {1.0, 2.0}) builder.add("nodes", {{"mesh", mesh}, {"translation", {x, 0, 0}}});
  LoadOptions options;
  options.scene = 0;
  CHECK_FAILURE(builder.failure(options), 1, "--scene");
  builder.json["scenes"] = {{{"nodes", {0}}, {"name", "near"}}, {{"nodes", {1}}}};
  builder.json["scene"] = 7;
  CHECK(builder.load(options).corner(0, 0).x == 1);
  options.scene = 1;
  const Scene scene = builder.load(options);
  CHECK(scene.corner(0, 0).x == 2);
  CHECK(scene.notes().scene == 1);
  CHECK(scene.notes().scenes == std::vector<std::string>{"near", ""});
  for (const int none : {2, -1}) {
    options.scene = none;
    CHECK_FAILURE(builder.failure(options), 1, "--scene");
  }
  CHECK_FAILURE(builder.failure(), 2, "scene");
}

TEST_CASE("nodes of other scenes, and maps of nodes that place nothing, may be broken") {
  GltfBuilder builder = one_triangle();
  builder.root({{"scale", {1e200, 1, 1}}, {"rotation", {0, 0, 1e200, 0}}, {"skin", 9}});
  builder.add("nodes", {{"scale", {1e300, 1, 1}}, {"rotation", {0, 0, 1e200, 0}}, {"mesh", 9}});
  CHECK(builder.load().triangles().size() == 1);
}

TEST_CASE("a scene without nodes is empty") {
  GltfBuilder builder;
  builder.json["scenes"] = {{{"name", "nothing"}}};
  CHECK(builder.load().primitive_count() == 0);
}

TEST_CASE("cycles, several parents and stray indices are errors that name the node") {
  GltfBuilder builder = one_triangle();
  builder.json["nodes"][0]["children"] = {0};
  CHECK_FAILURE(builder.failure(), 2, "nodes[0]");
  builder.json["nodes"] = {{{"children", {1}}}, {{"children", {2}}}, {{"children", {1}}}};
  CHECK_FAILURE(builder.failure(), 2, "nodes[1]");
  builder.json["nodes"] = {{{"name", "root"}}, {{"children", {2}}}, {{"children", {1}}}};
  CHECK_FAILURE(builder.failure(), 2, "nodes[1]");
  builder.json["nodes"] = {{{"children", {1, 1}}}, Json::object()};
  CHECK_FAILURE(builder.failure(), 2, "nodes[1]");
  builder.json["nodes"] = {{{"children", {7}}}};
  CHECK_FAILURE(builder.failure(), 2, "nodes[0].children");
  builder.json["nodes"] = {{{"children", {1}}}, Json::object()};
  builder.json["scenes"] = {{{"nodes", {1}}}};
  CHECK_FAILURE(builder.failure(), 2, "scenes[0].nodes");
  builder.json["scenes"] = {{{"nodes", {0, 0}}}};
  CHECK_FAILURE(builder.failure(), 2, "scenes[0].nodes");
  builder.json["scenes"] = {{{"nodes", {9}}}};
  CHECK_FAILURE(builder.failure(), 2, "scenes[0].nodes");
  builder.json["scenes"] = {{{"nodes", {0}}}};
  builder.json["nodes"][1]["mesh"] = 3;
  CHECK_FAILURE(builder.failure(), 2, "nodes[1]");
}

TEST_CASE("a chain of a hundred thousand nodes needs no deep stack") {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions(triangle_coordinates));
  const int depth = 100'000;
  builder.root({{"children", {1}}});
  for (int n = 1; n < depth; ++n) builder.add("nodes", {{"children", {n + 1}}, {"translation", {1, 0, 0}}});
  builder.add("nodes", {{"mesh", mesh}});
  CHECK(builder.load().corner(0, 0).x == depth - 1);
}

TEST_CASE("maps that are not affine or overflow are errors that name the node") {
  const Json perspective = {{"matrix", {1, 0, 0, 0.5, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}};
  CHECK_FAILURE(one_triangle(Json::object(), perspective).failure(), 2, "nodes[0].matrix");
  CHECK_FAILURE(one_triangle(Json::object(), {{"matrix", {1, 0, 0}}}).failure(), 2, "nodes[0].matrix");
  CHECK_FAILURE(one_triangle(Json::object(), {{"rotation", {1e200, 0, 0, 0}}}).failure(), 2, "nodes[0]");
  Json both = perspective;
  both["translation"] = {1, 0, 0};
  CHECK_FAILURE(one_triangle(Json::object(), both).failure(), 2, "nodes[0]");
  GltfBuilder builder;
  builder.root({{"mesh", builder.mesh(builder.positions<float>({0, 0, 0, 3e38f, 0, 0, 0, 1, 0}))},
                {"scale", {1e300, 1, 1}}});
  CHECK_FAILURE(builder.failure(), 2, "nodes[0]");
}

}  // namespace
}  // namespace provis
