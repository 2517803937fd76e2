// Published scenes load with the counts that their README states and the hashes that a second loader,
// reference_loader.py, computes; and they survive an export.
#include <catch2/catch.hpp>

#include "tests/scene/files.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

/// From real_scenes.txt; empty if the scene is not listed.
std::string reference_hash(const std::string& name) {
  std::istringstream lines(read_text(std::string(PROVIS_SOURCE_DIR) + "/tests/scene/real_scenes.txt"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string scene, triangles, hash;
    if (words >> scene >> triangles >> hash && scene == name) return hash;
  }
  return {};
}

void check_scene(const std::string& name, std::size_t triangles) {
  const auto file = test::shared_scene(name);
  if (!file) return;
  const Scene scene = load_scene(*file);
  CAPTURE(name);
  CHECK(scene.triangles().size() == triangles);
  CHECK(scene.hash() == reference_hash(name));
  std::size_t covered = 0;
  for (const SourceRange& source : scene.sources()) covered += source.count;
  CHECK(covered == triangles);

  const TempFolder folder;
  export_ply(scene, folder.path() / "x.ply");
  CHECK(load_scene(folder.path() / "x.ply").hash() == scene.hash());
}

TEST_CASE("bevy_cornell loads") { check_scene("bevy_cornell", 36); }
TEST_CASE("step_dm1 loads") { check_scene("step_dm1", 2660); }
TEST_CASE("godot_living_room loads") { check_scene("godot_living_room", 5088); }
TEST_CASE("quake_bsp_dm4 loads") { check_scene("quake_bsp_dm4", 5426); }
TEST_CASE("step_as1 loads") { check_scene("step_as1", 7488); }
TEST_CASE("recast_dungeon loads") { check_scene("recast_dungeon", 10133); }
TEST_CASE("sponza_dabrovic_a loads") { check_scene("sponza_dabrovic_a", 56100); }
TEST_CASE("sponza_dabrovic_b loads") { check_scene("sponza_dabrovic_b", 76154); }
TEST_CASE("quake_bsp_e1m1 loads") { check_scene("quake_bsp_e1m1", 15768); }
TEST_CASE("ifc_duplex loads") { check_scene("ifc_duplex", 26774); }
TEST_CASE("vox_monu1 loads") { check_scene("vox_monu1", 66444); }
TEST_CASE("ifc_mini_project loads") { check_scene("ifc_mini_project", 261069); }

TEST_CASE("strips, sparse and quantised accessors of published files load") {
  check_scene("tile_triangle_strip", 18584);
  check_scene("khr_SimpleSparseAccessor", 12);
  check_scene("pc_PrimitiveModeNormalsTest", 2562);
  check_scene("gt_ShapeCollection", 3542);
}

TEST_CASE("flags of a published file follow its materials") {
  const auto file = test::shared_scene("quake_bsp_dm4");
  if (!file) return;
  const SceneSummary material = summarize(load_scene(*file));
  CHECK(material.see_through > 0);
  CHECK(material.single_sided + material.see_through == material.triangles);
  const SceneSummary plain = summarize(load_scene(*file, {Sides::both, Opacity::all}));
  CHECK((plain.see_through == 0 && plain.single_sided == 0));
}

}  // namespace
}  // namespace provis
