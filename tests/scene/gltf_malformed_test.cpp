// Containers, JSON and members that are not what they should be.
#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

std::string with_word(std::string glb, std::size_t offset, std::uint32_t word) {
  return glb.replace(offset, 4, bytes_of<std::uint32_t>({word}));
}

Failure glb_failure(const std::string& content) { return load_failure("scene.glb", content); }

Failure json_failure(const std::string& text) { return load_failure("scene.gltf", text); }

TEST_CASE("broken GLB containers are errors that name the byte") {
  const std::string glb = one_triangle().glb();
  CHECK_FAILURE(glb_failure(""), 2, "byte 0");
  CHECK_FAILURE(glb_failure("glTF"), 2, "byte 4");
  CHECK_FAILURE(glb_failure(with_word(glb, 4, 1)), 3, "byte 4");
  CHECK_FAILURE(glb_failure(with_word(glb, 4, 3)), 3, "byte 4");
  CHECK_FAILURE(glb_failure(with_word(glb, 8, static_cast<std::uint32_t>(glb.size() + 1))), 2, "byte 8");
  CHECK_FAILURE(glb_failure(with_word(glb, 8, 3)), 2, "byte 8");
  CHECK_FAILURE(glb_failure(with_word(glb, 8, 15)), 2, "byte 12");
  CHECK_FAILURE(glb_failure(with_word(glb, 12, 0xFFFFFFFF)), 2, "byte 12");
  CHECK_FAILURE(glb_failure(with_word(glb, 16, 0x004E4942)), 2, "byte 16");
  CHECK_FAILURE(glb_failure(glb.substr(0, glb.size() - 1)), 2, "byte 8");
}

TEST_CASE("every truncation of a GLB is an error and never a crash") {
  const std::string glb = one_triangle().glb();
  for (std::size_t size = 0; size < glb.size(); ++size) {
    CAPTURE(size);
    CHECK(glb_failure(glb.substr(0, size)).status == 2);
  }
}

TEST_CASE("what follows a GLB's declared end is ignored") {
  CHECK(load_content("scene.glb", one_triangle().glb() + "trailing bytes").triangles().size() == 1);
}

TEST_CASE("the file's name is no part of the format") {
  CHECK(load_content("scene.ply", one_triangle().glb()).triangles().size() == 1);
  CHECK_FAILURE(load_failure("scene.glb", "solid stl"), 2, "byte 0");
}

TEST_CASE("broken JSON is an error that names the byte") {
  CHECK_FAILURE(json_failure("{\"asset\":}"), 2, "JSON byte 10");
  CHECK_FAILURE(json_failure("{\"asset\":{\"version\":\"2.0\"}"), 2, "JSON byte 27");
  CHECK_FAILURE(json_failure("{\"asset\":{\"version\":\"2.0\"}, \"x\": 1e999}"), 2, "JSON byte 34");
}

TEST_CASE("deeply nested JSON exhausts no stack") {
  const std::size_t depth = 1'000'000;
  const std::string nested = std::string(depth, '[') + std::string(depth, ']');
  CHECK(json_failure("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + nested + "}").status == 0);
}

TEST_CASE("other versions of glTF are unsupported") {
  CHECK_FAILURE(json_failure("{\"asset\":{\"version\":\"1.0\"}}"), 3, "asset.version");
  CHECK_FAILURE(json_failure("{\"asset\":{\"version\":\"2.5\",\"minVersion\":\"2.1\"}}"), 3,
                "asset.minVersion");
  CHECK_FAILURE(json_failure("{\"asset\":{\"version\":\"two\"}}"), 2, "asset.version");
  CHECK_FAILURE(json_failure("{\"asset\":{}}"), 2, "asset");
  CHECK_FAILURE(json_failure("{}"), 2, "asset");
}

Failure after(void (*change)(Json&)) {
  GltfBuilder builder = one_triangle({{"indices", 1}});
  builder.indices<std::uint16_t>({0, 1, 2});
  change(builder.json);
  return builder.failure();
}

TEST_CASE("members of the wrong kind are errors, where tinygltf would pass over them") {
  CHECK(after([](Json&) {}).status == 0);
  CHECK_FAILURE(after([](Json& j) { j["nodes"] = Json::object(); }), 2, "nodes");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0] = 3; }), 2, "nodes[0]");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["mesh"] = "0"; }), 2, "nodes[0].mesh");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["mesh"] = -1; }), 2, "nodes[0].mesh");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["mesh"] = 4294967296; }), 2, "nodes[0].mesh");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["mesh"] = 0.5; }), 2, "nodes[0].mesh");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["translation"] = {0, 0}; }), 2, "nodes[0].translation");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["scale"] = {1, "1", 1}; }), 2, "nodes[0].scale[1]");
  CHECK_FAILURE(after([](Json& j) { j["nodes"][0]["children"] = 1; }), 2, "nodes[0].children");
  CHECK_FAILURE(after([](Json& j) { j["meshes"][0].erase("primitives"); }), 2, "meshes[0]");
  CHECK_FAILURE(after([](Json& j) { j["meshes"][0]["primitives"][0].erase("attributes"); }), 2,
                "meshes[0].primitives[0]");
  CHECK_FAILURE(after([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 1.5; }), 2,
                "meshes[0].primitives[0].attributes.POSITION");
  CHECK_FAILURE(after([](Json& j) { j["meshes"][0]["primitives"][0]["indices"] = 9; }), 2,
                "meshes[0].primitives[0].indices");
  CHECK_FAILURE(after([](Json& j) { j["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 9; }), 2,
                "meshes[0].primitives[0].attributes.POSITION");
  CHECK_FAILURE(after([](Json& j) { j["accessors"][0].erase("count"); }), 2, "accessors[0]");
  CHECK_FAILURE(after([](Json& j) { j["accessors"][0]["type"] = "VEC5"; }), 2, "accessors[0].type");
  CHECK_FAILURE(after([](Json& j) { j["accessors"][0]["componentType"] = 5130; }), 2,
                "accessors[0].componentType");
  CHECK_FAILURE(after([](Json& j) { j["accessors"][0]["bufferView"] = 9; }), 2, "accessors[0]");
  CHECK_FAILURE(after([](Json& j) {
                  j["accessors"][1]["sparse"] = {{"count", 1}};
                }),
                2, "accessors[1].sparse");
  CHECK_FAILURE(after([](Json& j) { j["bufferViews"][0]["byteStride"] = 6; }), 2,
                "bufferViews[0].byteStride");
  CHECK_FAILURE(after([](Json& j) { j["bufferViews"][0]["buffer"] = 9; }), 2, "bufferViews[0]");
  CHECK_FAILURE(after([](Json& j) { j["buffers"] = {{{"byteLength", 1000}}}; }), 2, "buffers[0]");
  CHECK_FAILURE(after([](Json& j) { j["scene"] = "0"; }), 2, "document.scene");
}

TEST_CASE("whole numbers written with a point are accepted") {
  CHECK(after([](Json& j) {
          j["accessors"][0]["count"] = 3.0;
          j["nodes"][0]["mesh"] = 0.0;
        }).status == 0);
}

TEST_CASE("what no triangle needs may be broken") {
  CHECK(after([](Json& j) {
          j["images"] = {{{"uri", "missing.png"}}, {{"bufferView", 77}}, 5};
          j["textures"] = {{{"source", 9}}};
          j["samplers"] = "none";
          j["animations"] = {{{"channels", 3}}};
          j["cameras"] = {{{"type", "fisheye"}}};
          j["nodes"][0]["name"] = 12;
          j["nodes"][0]["camera"] = "front";
          j["materials"] = {{{"emissiveFactor", {1, 2}}, {"pbrMetallicRoughness", 5}}};
          j["buffers"] = {{{"byteLength", 42}}, {{"byteLength", 7}, {"uri", "missing.bin"}}};
        }).status == 0);
}

TEST_CASE("a primitive without positions draws nothing") {
  GltfBuilder builder = one_triangle();
  builder.json["meshes"][0]["primitives"][0]["attributes"] = {{"NORMAL", 0}};
  CHECK(builder.load().primitive_count() == 0);
}

TEST_CASE("a missing file and a folder are errors that name the file") {
  const TempFolder folder;
  const auto missing = folder.path() / "missing.glb";
  CHECK_FAILURE(failure_of([&] { load_scene(missing); }), 2, missing.string());
  CHECK_FAILURE(failure_of([&] { load_scene(folder.path()); }), 2, folder.path().string());
}

TEST_CASE("an error's message names file and place once") {
  const TempFolder folder;
  GltfBuilder builder = one_triangle();
  builder.json["accessors"][0]["type"] = "VEC5";
  const auto file = folder.write("scene.glb", builder.glb());
  CHECK(failure_of([&] { load_scene(file); }).message ==
        file.string() + ": accessors[0].type: unknown type \"VEC5\"");
}

}  // namespace
}  // namespace provis
