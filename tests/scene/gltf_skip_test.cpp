// --skip-invalid on glTF: one broken thing loses what uses it, which is listed, and nothing else.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

LoadOptions skipping() {
  LoadOptions options;
  options.skip_invalid = true;
  return options;
}

/// A mesh of three primitives over accessor 0 (one triangle); the one in the middle is for breaking.
GltfBuilder three_primitives() {
  GltfBuilder builder = one_triangle();
  Json& primitives = builder.json["meshes"][0]["primitives"];
  primitives.push_back(Json(primitives[0]));
  primitives.push_back(Json(primitives[0]));
  return builder;
}

Json& middle(GltfBuilder& builder) { return builder.json["meshes"][0]["primitives"][1]; }

/// The default is an error at `place`; skipping keeps the primitives 0 and 2 and lists the middle one.
void check_only_middle_lost(const GltfBuilder& builder, int status, const std::string& place,
                            const std::string& reason) {
  CHECK_FAILURE(builder.failure(), status, place);
  const Scene scene = builder.load(skipping());
  REQUIRE(scene.left_out().size() == 1);
  CHECK_THAT(scene.left_out()[0].place, Catch::Contains("meshes[0].primitives[1]"));
  CHECK_THAT(scene.left_out()[0].reason, Catch::Contains(reason));
  CHECK(scene.triangles().size() == 2);
  CHECK(scene.vertices().size() == 6);
  REQUIRE(scene.sources().size() == 2);
  CHECK(scene.sources()[0].primitive == 0);
  CHECK(scene.sources()[1].primitive == 2);
}

TEST_CASE("a sound file loses nothing by skipping") {
  const GltfBuilder builder = three_primitives();
  const Scene scene = builder.load(skipping());
  CHECK(scene.left_out().empty());
  CHECK(scene.hash() == builder.load().hash());
}

TEST_CASE("a primitive that is broken itself is left out") {
  GltfBuilder builder = three_primitives();
  SECTION("an accessor that does not exist") {
    middle(builder)["indices"] = 77;
    check_only_middle_lost(builder, 2, "meshes[0].primitives[1].indices", "accessor 77 of 1");
  }
  SECTION("a member of a wrong kind") {
    middle(builder)["attributes"] = "POSITION";
    check_only_middle_lost(builder, 2, "meshes[0].primitives[1].attributes", "string instead of an object");
  }
  SECTION("a missing member") {
    middle(builder).erase("attributes");
    check_only_middle_lost(builder, 2, "meshes[0].primitives[1]", "attributes is missing");
  }
  SECTION("an unknown mode") {
    middle(builder)["mode"] = 9;
    check_only_middle_lost(builder, 2, "meshes[0].primitives[1].mode", "unknown mode 9");
  }
}

TEST_CASE("a broken accessor, view or material loses the primitives that use it") {
  GltfBuilder builder = three_primitives();
  middle(builder)["attributes"]["POSITION"] = builder.positions<float>({0, 0, 1, 1, 0, 1, 0, 1, 1});
  SECTION("an accessor without its count") {
    builder.json["accessors"][1].erase("count");
    check_only_middle_lost(builder, 2, "accessors[1]", "accessors[1]: count is missing");
  }
  SECTION("an accessor with a word for a number") {
    builder.json["accessors"][1]["count"] = "three";
    check_only_middle_lost(builder, 2, "accessors[1].count", "string instead of an integer");
  }
  SECTION("an accessor that overruns its view") {
    builder.json["accessors"][1]["count"] = 4;
    check_only_middle_lost(builder, 2, "accessors[1]", "do not fit");
  }
  SECTION("a view with a stride that glTF does not have") {
    builder.json["bufferViews"][1]["byteStride"] = 13;
    check_only_middle_lost(builder, 2, "bufferViews[1].byteStride", "13 is no multiple of 4");
  }
  SECTION("a coordinate that is not finite") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    middle(builder)["attributes"]["POSITION"] = builder.positions<float>({0, 0, 1, 1, nan, 1, 0, 1, 1});
    check_only_middle_lost(builder, 2, "accessors[2]", "element 1 is not finite");
  }
  SECTION("a material of an unknown alpha mode") {
    middle(builder)["material"] = builder.add("materials", {{"alphaMode", "GLASS"}});
    check_only_middle_lost(builder, 2, "materials[0].alphaMode", "unknown mode \"GLASS\"");
  }
}

TEST_CASE("without skipping, what no triangle needs may lack members, but not be of a wrong kind") {
  GltfBuilder builder = one_triangle();
  SECTION("missing members") {
    builder.add("accessors", Json::object());
    builder.add("bufferViews", Json::object());
    builder.add("buffers", {{"byteLength", builder.binary.size()}});
    builder.add("buffers", Json::object());
    builder.add("meshes", Json::object());
    builder.add("skins", Json::object());
    builder.add("materials", {{"alphaMode", "GLASS"}});
    CHECK(builder.load().triangles().size() == 1);
  }
  SECTION("wrong kinds") {
    builder.add("meshes", {{"primitives", "none"}});
    CHECK_FAILURE(builder.failure(), 2, "meshes[1].primitives");
    CHECK(builder.load(skipping()).left_out().empty());
  }
}

TEST_CASE("a node that cannot place its mesh is left out, its neighbours are not") {
  GltfBuilder builder = one_triangle();
  builder.root({{"mesh", 4}});
  builder.root({{"mesh", 0}, {"scale", {1e308, 1e308, 1e308}}, {"translation", {1.7e308, 0, 0}}});
  builder.root({{"mesh", 0}, {"translation", {0, 0, 1}}});
  CHECK_FAILURE(builder.failure(), 2, "nodes[1]");
  const Scene scene = builder.load(skipping());
  CHECK(scene.triangles().size() == 2);
  CHECK(scene.vertices().size() == 6);
  REQUIRE(scene.left_out().size() == 2);
  CHECK(scene.left_out()[0].place == "nodes[1]");
  CHECK(scene.left_out()[1].place == "nodes[2]: meshes[0].primitives[0]");
  CHECK_THAT(scene.left_out()[1].reason, Catch::Contains("overflows"));
  REQUIRE(scene.sources().size() == 2);
  CHECK(scene.sources()[1].node == 3);
}

TEST_CASE("an instance that overflows is left out alone") {
  GltfBuilder builder = one_triangle();
  const int shift = builder.accessor<float>("VEC3", 3, {0, 0, 0, 3e38f, 0, 0, 0, 0, 5});
  builder.json["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] = shift;
  builder.json["nodes"][0]["scale"] = {1e300, 1, 1};
  CHECK_FAILURE(builder.failure(), 2, "nodes[0]");
  const Scene scene = builder.load(skipping());
  CHECK(scene.left_out().size() == 1);
  REQUIRE(scene.sources().size() == 2);
  CHECK(scene.sources()[0].instance == 0);
  CHECK(scene.sources()[1].instance == 2);
}

TEST_CASE("the hierarchy itself must be sound even when skipping") {
  GltfBuilder builder = one_triangle();
  builder.json["nodes"][0]["children"] = {0};
  CHECK(builder.failure(skipping()).status == 2);
  builder.json["nodes"][0]["children"] = "none";
  CHECK(builder.failure(skipping()).status == 2);
}

}  // namespace
}  // namespace provis
