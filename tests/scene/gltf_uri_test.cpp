// Buffers outside the document: data URIs, files beside it, and files that must not be opened.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

/// The triangle (0,0,0), (1,0,0), (0,1,0) as float32, in base64.
const char triangle_base64[] = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

/// A text document whose only buffer has that uri.
std::string document(const std::string& uri) {
  Json json = one_triangle().json;
  json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
  return json.dump();
}

Failure uri_failure(const std::string& uri) { return load_failure("scene.gltf", document(uri)); }

void check_triangle(const Scene& scene) {
  REQUIRE(scene.triangles().size() == 1);
  CHECK(scene.corner(0, 1) == Vec3d{1, 0, 0});
  CHECK(scene.corner(0, 2) == Vec3d{0, 1, 0});
}

TEST_CASE("data URIs of any media type are decoded") {
  check_triangle(load_content(
      "scene.gltf", document(std::string("data:application/octet-stream;base64,") + triangle_base64)));
  check_triangle(load_content("scene.gltf", document(std::string("data:;base64,") + triangle_base64)));
  check_triangle(
      load_content("scene.gltf", document(std::string("data:model/x;charset=y;base64,") + triangle_base64)));
}

TEST_CASE("base64 may be padded, and longer than the buffer") {
  // Two zero bytes more than needed: 38 bytes end in one padding character.
  check_triangle(
      load_content("scene.gltf", document(std::string("data:;base64,") + triangle_base64 + "AAA=")));
  check_triangle(
      load_content("scene.gltf", document(std::string("data:;base64,") + triangle_base64 + "AAA")));
}

TEST_CASE("data URIs without base64 are percent-decoded") {
  std::string uri = "data:application/octet-stream,";
  for (const unsigned char byte : one_triangle().binary) uri += fmt::format("%{:02x}", byte);
  check_triangle(load_content("scene.gltf", document(uri)));
}

TEST_CASE("broken data URIs are errors") {
  CHECK_FAILURE(uri_failure("data:;base64,AAAA"), 2, "buffers[0]");
  CHECK_FAILURE(uri_failure("data:;base64,A!AA"), 2, "buffers[0].uri");
  CHECK_FAILURE(uri_failure("data:;base64,AAAAA"), 2, "buffers[0].uri");
  CHECK_FAILURE(uri_failure("data:nothing"), 2, "buffers[0].uri");
}

TEST_CASE("files in the scene's folder and below are read") {
  const TempFolder folder;
  folder.write("parts/my mesh.bin", one_triangle().binary);
  check_triangle(load_scene(folder.write("scene.gltf", document("parts/my%20mesh.bin"))));
  check_triangle(load_scene(folder.write("scene.gltf", document("./parts/my mesh.bin"))));
}

TEST_CASE("a relative path to the scene works from its own folder") {
  const TempFolder folder;
  folder.write("mesh.bin", one_triangle().binary);
  folder.write("scene.gltf", document("mesh.bin"));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const Failure failure = failure_of([] { check_triangle(load_scene("scene.gltf")); });
  std::filesystem::current_path(before);
  CHECK(failure.message.empty());
}

TEST_CASE("nothing outside the scene's folder is opened") {
  const TempFolder folder;
  const auto secret = folder.write("secret.bin", one_triangle().binary);
  const auto load = [&](const std::string& uri) {
    const auto scene = folder.write("inner/scene.gltf", document(uri));
    return failure_of([&] { load_scene(scene); });
  };
  const std::string place = (folder.path() / "inner/scene.gltf").string() + ": buffers[0].uri";
  const std::string uris[] = {"../secret.bin",  "%2e%2e/secret.bin",         "..%2Fsecret.bin",
                              "..\\secret.bin", "x/../../secret.bin",        secret.string(),
                              "%2Fetc/passwd",  "file://" + secret.string(), "http://example.org/mesh.bin",
                              "C:\\mesh.bin",   "\\\\server\\mesh.bin"};
  for (const std::string& uri : uris) {
    const Failure failure = load(uri);
    CHECK_FAILURE(failure, 2, place);
    CHECK_THAT(failure.message, Catch::Contains("leaves the scene's folder"));
  }
}

TEST_CASE("a link that leads out of the folder is not followed") {
  const TempFolder folder;
  const auto secret = folder.write("secret.bin", one_triangle().binary);
  const auto scene = folder.write("inner/scene.gltf", document("link.bin"));
  std::filesystem::create_symlink(secret, folder.path() / "inner/link.bin");
  CHECK_THAT(failure_of([&] { load_scene(scene); }).message, Catch::Contains("leaves the scene's folder"));
}

TEST_CASE("missing, short and irregular buffer files are errors") {
  CHECK_FAILURE(uri_failure("missing.bin"), 2, "buffers[0].uri");
  CHECK_FAILURE(uri_failure(""), 2, "buffers[0].uri");
  CHECK_FAILURE(uri_failure("."), 2, "buffers[0].uri");
  const TempFolder folder;
  folder.write("short.bin", one_triangle().binary.substr(1));
  const auto scene = folder.write("scene.gltf", document("short.bin"));
  CHECK_FAILURE(failure_of([&] { load_scene(scene); }), 2, scene.string() + ": buffers[0]");
}

TEST_CASE("text glTF has no binary chunk to fall back on") {
  Json json = one_triangle().json;
  json["buffers"] = {{{"byteLength", 36}}};
  CHECK_FAILURE(load_failure("scene.gltf", json.dump()), 2, "buffers[0]");
}

}  // namespace
}  // namespace provis
