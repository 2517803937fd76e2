// export_ply: the format byte for byte, and that it reads back.
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/scene/files.hpp"
#include "tests/scene/fixed_scene.hpp"

namespace provis {
namespace {

void check_same(const Scene& a, const Scene& b) {
  CHECK(a.hash() == b.hash());
  CHECK(std::vector(a.triangles().begin(), a.triangles().end()) ==
        std::vector(b.triangles().begin(), b.triangles().end()));
  CHECK(std::vector(a.triangle_flags().begin(), a.triangle_flags().end()) ==
        std::vector(b.triangle_flags().begin(), b.triangle_flags().end()));
  CHECK(std::vector(a.vertices().begin(), a.vertices().end()) ==
        std::vector(b.vertices().begin(), b.vertices().end()));
}

TEST_CASE("an exported scene has the stated bytes") {
  const TempFolder folder;
  SceneArrays arrays;
  arrays.vertices = {{0, 1, 2}, {3, 4, 5}, {6, 7, -0.0}};
  arrays.triangles = {{2, 0, 1}};
  arrays.triangle_flags = {3};
  arrays.spheres = {{{8, 9, 10}, 0.5}};
  arrays.sphere_flags = {1};
  const Scene scene(arrays);
  export_ply(scene, folder.path() / "x.ply");
  CHECK(
      read_text(folder.path() / "x.ply") ==
      "ply\nformat binary_little_endian 1.0\ncomment provis-scene-hash " + scene.hash() +
          "\ncomment flags: bit 0 single-sided, bit 1 see-through\nelement vertex 3\nproperty double "
          "x\nproperty double y\n"
          "property double z\nelement face 1\nproperty list uchar uint vertex_indices\nproperty uchar flags\n"
          "element sphere 1\nproperty double x\nproperty double y\nproperty double z\nproperty double "
          "radius\n"
          "property uchar flags\nend_header\n" +
          bytes_of<double>({0, 1, 2, 3, 4, 5, 6, 7, -0.0}) + "\x03" + bytes_of<std::uint32_t>({2, 0, 1}) +
          "\x03" + bytes_of<double>({8, 9, 10, 0.5}) + "\x01");
}

TEST_CASE("an exported scene reads back to the same hash, bit for bit") {
  const TempFolder folder;
  const Scene scene(fixed_arrays());
  const auto file = folder.path() / "x.ply";
  export_ply(scene, file);
  const Scene back = load_scene(file);
  check_same(scene, back);
  CHECK(std::signbit(back.vertices()[1].y));
  CHECK(back.sphere_flags()[1] == see_through);
}

TEST_CASE("scenes without triangles, without spheres and without anything read back") {
  const TempFolder folder;
  const auto file = folder.path() / "x.ply";
  SceneArrays spheres = fixed_arrays();
  spheres.triangles.clear();
  spheres.triangle_flags.clear();
  SceneArrays triangles = fixed_arrays();
  triangles.spheres.clear();
  triangles.sphere_flags.clear();
  for (const SceneArrays& arrays : {spheres, triangles, SceneArrays{}}) {
    const Scene scene(arrays);
    export_ply(scene, file);
    check_same(scene, load_scene(file));
  }
}

TEST_CASE("many triangles read back") {
  const TempFolder folder;
  SceneArrays arrays;
  for (std::uint32_t i = 0; i < 30'000; ++i) {
    arrays.vertices.push_back({0.1 * i, 1.0 / (i + 1), -1.0 * i});
    arrays.triangles.push_back({i, i / 2, i / 3});
    arrays.triangle_flags.push_back(static_cast<std::uint8_t>(i % 4));
  }
  const Scene scene(arrays);
  export_ply(scene, folder.path() / "x.ply");
  check_same(scene, load_scene(folder.path() / "x.ply"));
}

TEST_CASE("content that does not have the hash of its comment is an error, whatever the options") {
  const TempFolder folder;
  const auto file = folder.path() / "x.ply";
  export_ply(Scene(fixed_arrays()), file);
  std::string bytes = read_text(file);
  bytes[bytes.find("end_header\n") + 11] ^= 1;
  folder.write("x.ply", bytes);
  CHECK_FAILURE(failure_of([&] { load_scene(file); }), 2, file.string() + ": comment");
  CHECK_FAILURE(failure_of([&] {
                  load_scene(file, {Sides::both, Opacity::all});
                }),
                2, file.string() + ": comment");
}

TEST_CASE("the comment's hash is that of the file, not of what the options make of it") {
  const TempFolder folder;
  const Scene scene(fixed_arrays());
  export_ply(scene, folder.path() / "x.ply");
  const Scene changed = load_scene(folder.path() / "x.ply", {Sides::both, Opacity::all});
  CHECK(changed.hash() != scene.hash());
  CHECK(changed.triangle_flags()[2] == 0);
  CHECK(changed.sphere_flags()[0] == 0);
}

TEST_CASE("an export that cannot be written says so and leaves nothing behind") {
  const TempFolder folder;
  const auto file = folder.path() / "missing" / "x.ply";
  const Failure failure = failure_of([&] { export_ply(Scene(fixed_arrays()), file); });
  CHECK_FAILURE(failure, 4, file.string());
  CHECK_THAT(failure.message, Catch::Contains("No such file or directory"));
  CHECK_FAILURE(failure_of([&] { export_ply(Scene(fixed_arrays()), folder.path()); }), 4,
                folder.path().string());
  CHECK(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace provis
