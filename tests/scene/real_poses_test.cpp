// Published scenes with skins, morph targets, instances and points: the counts and extents that their README
// states. Its extents are those of the mesh nodes' own maps, without skins and morph weights, so these are
// taken out before the comparison; what they make of a scene at rest is in the second evaluator's hashes
// (real_scenes.txt) and here where it can be told without one.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "tests/scene/files.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

using Json = nlohmann::json;

struct Expected {
  const char* name;
  std::size_t triangles;
  Vec3d lower, upper;  ///< to four digits
};

const Expected scenes[] = {
    {"assimp_simple_skin", 8, {0, 0, 0}, {1, 2, 0}},
    {"blender_gpu_instancing", 7656770, {-339.4, 0, -339.4}, {339.4, 13.3, 339.4}},
    {"blender_skinned_cylinder", 316, {-1, -1, -4}, {1, 1, 0}},
    {"khr_AnimatedMorphCube", 12, {-1, -1, -1}, {1, 1, 1}},
    {"khr_AnimatedMorphSphere", 960, {-1, -1, -1}, {1, 1, 1}},
    {"khr_BrainStem", 61666, {-1.252, -0.0005403, -0.3414}, {1.163, 1.834, 0.2557}},
    {"khr_CesiumMan", 4672, {-0.5691, -3.678e-17, -0.131}, {0.5691, 1.507, 0.181}},
    {"khr_Fox", 576, {-12.59, -0.1217, -88.1}, {12.59, 78.91, 66.62}},
    {"khr_InterpolationTest", 110, {-4.387, -2.159, -1}, {4.348, 7.959, 1.009}},
    {"khr_MorphPrimitivesTest", 32, {-0.5, 0, -0.5}, {0.5, 0, 0.5}},
    {"khr_MorphStressTest", 2412, {-2, -0.1, -0.5}, {2, 0.5, 0.5}},
    {"khr_SimpleInstancing", 1500, {-1.667, -1.667, -1.667}, {12.73, 12.73, 12.73}},
    {"khr_SimpleMorph", 1, {0, 0, 0}, {1, 0.5, 0}},
    {"pc_PrimitiveModeNormalsTest", 2562, {-10, -7, -1.5}, {10, 7, 1.5}},
    {"pc_lumberjack_vat", 1538, {-80.01, -1.524e-14, -39.09}, {78.44, 170.3, 88.41}},
    {"sharp_GrassFieldInstanced", 1155872, {-1625, -155.1, -1595}, {1577, 187.9, 1561}},
    {"sharp_InfiniteSkinnedTentacle", 6384, {-5, 0, -5}, {5, 90, 5}},
};

/// Rewrites a GLB's JSON chunk; the binary one stays.
template <class Change>
std::string changed_glb(const std::string& glb, const Change& change) {
  const auto word = [&glb](std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, glb.data() + offset, sizeof(value));
    return value;
  };
  const std::uint32_t size = word(12);
  Json document = Json::parse(glb.substr(20, size));
  change(document);
  std::string text = document.dump();
  text.append((4 - text.size() % 4) % 4, ' ');
  const std::string rest = glb.substr(20 + size);
  return "glTF" +
         bytes_of<std::uint32_t>({2, static_cast<std::uint32_t>(20 + text.size() + rest.size()),
                                  static_cast<std::uint32_t>(text.size()), 0x4E4F534A}) +
         text + rest;
}

void remove_deformations(Json& document) {
  for (Json& node : document["nodes"]) {
    node.erase("skin");
    node.erase("weights");
  }
  for (Json& mesh : document["meshes"]) mesh.erase("weights");
}

/// README numbers have four digits, half a unit of the last one is at most 5e-4 of the number; what is zero
/// but for rounding may differ by that, some float64 roundings of the scene's size.
void check_coordinate(double actual, double stated, double size) {
  CHECK(std::abs(actual - stated) <= 5e-4 * std::abs(stated) + 0x1p-40 * size);
}

void check_extent(const SceneSummary& summary, const Vec3d& lower, const Vec3d& upper) {
  const double size = std::max({upper.x - lower.x, upper.y - lower.y, upper.z - lower.z});
  check_coordinate(summary.lower.x, lower.x, size);
  check_coordinate(summary.lower.y, lower.y, size);
  check_coordinate(summary.lower.z, lower.z, size);
  check_coordinate(summary.upper.x, upper.x, size);
  check_coordinate(summary.upper.y, upper.y, size);
  check_coordinate(summary.upper.z, upper.z, size);
}

TEST_CASE("counts and undeformed extents of published scenes are those of their README") {
  for (const Expected& expected : scenes) {
    const auto file = test::shared_scene(expected.name);
    if (!file) continue;
    CAPTURE(expected.name);
    CHECK(load_scene(*file).triangles().size() == expected.triangles);
    const Scene plain = load_content("plain.glb", changed_glb(read_text(*file), remove_deformations));
    CHECK(plain.triangles().size() == expected.triangles);
    check_extent(summarize(plain), expected.lower, expected.upper);
  }
}

TEST_CASE("a skin at rest in its bind pose gives the undeformed mesh, to the float32 of its matrices") {
  for (const char* name : {"khr_CesiumMan", "khr_Fox"}) {
    const auto file = test::shared_scene(name);
    if (!file) continue;
    CAPTURE(name);
    const Scene posed = load_scene(*file);
    const Scene plain = load_content("plain.glb", changed_glb(read_text(*file), remove_deformations));
    const SceneSummary summary = summarize(posed);
    const double size = std::max({summary.upper.x - summary.lower.x, summary.upper.y - summary.lower.y,
                                  summary.upper.z - summary.lower.z});
    REQUIRE(posed.vertices().size() == plain.vertices().size());
    double worst = 0;
    for (std::size_t i = 0; i < posed.vertices().size(); ++i) {
      const Vec3d d = posed.vertices()[i] - plain.vertices()[i];
      worst = std::max({worst, std::abs(d.x), std::abs(d.y), std::abs(d.z)});
    }
    // A dozen nested joints and the inverse of their product, each number off by 2^-24 of the size.
    CHECK(worst < 64 * 0x1p-24 * size);
    CHECK(worst > 0);
  }
}

TEST_CASE("deformations that can be told by hand") {
  // The joints stand at the origin, while the bind matrices move the strip half a unit to the left.
  if (const auto file = test::shared_scene("assimp_simple_skin")) {
    const SceneSummary summary = summarize(load_scene(*file));
    CHECK((summary.lower == Vec3d{-0.5, 0, 0} && summary.upper == Vec3d{0.5, 2, 0}));
  }
  // Half of (-1, 1, 0) and half of (1, 1, 0) at the top.
  if (const auto file = test::shared_scene("khr_SimpleMorph"))
    CHECK(summarize(load_scene(*file)).upper == Vec3d{1, 1.5, 0});
  if (const auto file = test::shared_scene("khr_MorphPrimitivesTest"))
    CHECK(summarize(load_scene(*file)).upper == Vec3d{0.5, double{0.1f}, 0.5});
}

TEST_CASE("points of a published scene become spheres") {
  const auto file = test::shared_scene("pc_PrimitiveModeNormalsTest");
  if (!file) return;
  CHECK(load_scene(*file).skipped().points == 524288);
  LoadOptions options;
  options.radius = 0.5;
  const Scene scene = load_scene(*file, options);
  CHECK((scene.spheres().size() == 524288 && scene.skipped().points == 0));
}

TEST_CASE("ids of published instances lead back to them") {
  const auto file = test::shared_scene("sharp_GrassFieldInstanced");
  if (!file) return;
  const Scene scene = load_scene(*file);
  int instances = 0;
  for (const SourceRange& source : scene.sources()) instances += source.instance >= 0;
  CHECK(instances == 3000);
}

TEST_CASE("published animations are listed with their times") {
  const auto file = test::shared_scene("khr_Fox");
  if (!file) return;
  const FileNotes notes = load_scene(*file).notes();
  REQUIRE(notes.animations.size() == 3);
  CHECK((notes.animations[1].name == "Walk" && notes.animations[1].index == 1));
  CHECK((notes.animations[1].first == 0 && notes.animations[1].last == double{0.7083333134651184f}));
}

}  // namespace
}  // namespace provis
