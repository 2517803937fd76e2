// Where a primitive is from, and which primitives are a node's.

#include "src/report/source_report.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/scene/files.hpp"

using namespace provis;
using Json = nlohmann::json;

namespace {

/// Two triangles and a sphere of node 1, which has instances; the third instance begins at element 7.
SceneArrays arrays() {
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}};
  arrays.triangles = {{0, 1, 2}, {2, 1, 0}};
  arrays.triangle_flags = {0, single_sided | see_through};
  arrays.spheres = {{{1, 2, 3}, 0.25}};
  arrays.sphere_flags = {single_sided};
  SourceRange run;
  run.count = 3;
  run.node = 1;
  run.mesh = 4;
  run.primitive = 5;
  run.instance = 2;
  run.element = 7;
  arrays.sources = {run};
  arrays.node_names = {"", "door"};
  return arrays;
}

SceneArrays ply_arrays() {
  SceneArrays ply = arrays();
  ply.node_names.clear();
  SourceRange faces, spheres;
  faces.count = 2;
  faces.primitive = 1;
  faces.element = 12;
  faces.per_element = 2;
  spheres.first = 2;
  spheres.count = 1;
  spheres.primitive = 2;
  ply.sources = {faces, spheres};
  ply.notes.elements = {"vertex", "face", "sphere"};
  return ply;
}

}  // namespace

TEST_CASE("a triangle of a glTF file") {
  const Scene scene(arrays());
  CHECK(source_text("house.glb", scene, 1) ==
        "id         1 (triangle)\nfile       house.glb\nnode       1 \"door\"\ninstance   2\nmesh       4\n"
        "primitive  5\nelement    8\nmaterial   single-sided, see-through\n"
        "corner 0   0,1,0.5\ncorner 1   1,0,0\ncorner 2   0,0,0\n");
  const Json json = Json::parse(source_json("house.glb", scene, 1));
  CHECK(json["format"] == "provis.primitive-source");
  CHECK(json["hash"] == scene.hash());
  CHECK(json["kind"] == "triangle");
  CHECK(json["node"] == 1);
  CHECK(json["node_name"] == "door");
  CHECK((json["mesh"] == 4 && json["primitive"] == 5 && json["instance"] == 2 && json["element"] == 8));
  CHECK(json["corners"][0] == Json::array({0.0, 1.0, 0.5}));
  CHECK((json["single_sided"] == true && json["see_through"] == true));
}

TEST_CASE("a name with anything in it stays on its line") {
  SceneArrays odd = arrays();
  odd.node_names[1] = "a\n\"b\"\x1b[1m";
  CHECK_THAT(source_text("x", Scene(odd), 0), Catch::Contains("node       1 \"a\\n\\\"b\\\"\\u001b[1m\"\n"));
}

TEST_CASE("a sphere has a centre and a radius") {
  const Scene scene(arrays());
  CHECK_THAT(source_text("x", scene, 2), Catch::Contains("id         2 (sphere)\n") &&
                                             Catch::EndsWith("centre     1,2,3\nradius     0.25\n"));
  const Json json = Json::parse(source_json("x", scene, 2));
  CHECK(json["center"] == Json::array({1.0, 2.0, 3.0}));
  CHECK(json["radius"] == 0.25);
  CHECK_FALSE(json.contains("corners"));
}

TEST_CASE("a PLY file has rows of elements, and polygons of parts") {
  const Scene scene(ply_arrays());
  CHECK_THAT(source_text("x.ply", scene, 1), Catch::Contains("element    face 12\npart       1 of 2\n"));
  CHECK_THAT(source_text("x.ply", scene, 2), Catch::Contains("element    sphere 0\nmaterial"));
  CHECK_THAT(source_text("x.ply", scene, 1), !Catch::Contains("node"));
  const Json json = Json::parse(source_json("x.ply", scene, 1));
  CHECK((json["node"].is_null() && json["mesh"].is_null() && json["primitive"].is_null()));
  CHECK((json["element_name"] == "face" && json["element"] == 12 && json["part"] == 1 && json["parts"] == 2));
}

TEST_CASE("an id that is none is a usage error") {
  const Failure failure = failure_of([] { source_text("x", Scene(arrays()), 3); });
  CHECK(failure.status == 1);
  CHECK_THAT(failure.message, Catch::Contains("0 to 2"));
  CHECK(failure_of([] { source_json("x", Scene(arrays()), 3); }).status == 1);
}

TEST_CASE("the ids of nodes are ranges") {
  CHECK(node_ids_text({{0, 4}, {7, 7}}) == "0-4\n7-7\n");
  CHECK(node_ids_text({}).empty());
  const Scene scene(arrays());
  const Json json = Json::parse(node_ids_json("x", scene, {1}));
  CHECK(json["format"] == "provis.node-ids");
  CHECK(json["nodes"] == Json::array({1}));
  CHECK(json["ranges"] == Json::array({Json::array({0, 2})}));
  CHECK(Json::parse(node_ids_json("x", scene, {0}))["ranges"] == Json::array());
}
