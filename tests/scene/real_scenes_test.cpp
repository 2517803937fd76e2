// Published scenes have the counts and hashes that a second evaluator, reference_loader.py, computes; and
// they survive an export.
#include <catch2/catch.hpp>

#include "tests/scene/expected.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

void check_sources(const Scene& scene) {
  std::size_t covered = 0;
  for (const SourceRange& source : scene.sources()) covered += source.count;
  CHECK(covered == scene.primitive_count());
}

void check_export(const Scene& scene) {
  const TempFolder folder;
  export_ply(scene, folder.path() / "x.ply");
  CHECK(load_scene(folder.path() / "x.ply").hash() == scene.hash());
}

constexpr std::size_t millions = 1000000;

/// Those of real_scenes.txt that have so many triangles.
void check_scenes(std::size_t at_least, std::size_t below) {
  for (const auto& line : expected_lines("real_scenes.txt")) {
    REQUIRE(line.size() == 3);
    const std::size_t triangles = std::stoull(line[1]);
    if (triangles < at_least || triangles >= below) continue;
    const auto file = test::shared_scene(line[0]);
    if (!file) continue;
    CAPTURE(line[0]);
    const Scene scene = load_scene(*file);
    CHECK(scene.triangles().size() == triangles);
    CHECK(scene.hash() == line[2]);
    check_sources(scene);
    if (triangles < millions) check_export(scene);  // larger ones would take a gigabyte of disk
  }
}

TEST_CASE("small published scenes have the hashes of the second evaluator") { check_scenes(0, 30000); }
TEST_CASE("published scenes have the hashes of the second evaluator") { check_scenes(30000, millions); }

TEST_CASE("published scenes of millions of triangles have the hashes of the second evaluator") {
  if (test::nightly()) check_scenes(millions, std::size_t{1} << 32);
}

TEST_CASE("points of published scenes become spheres with the hashes of the second evaluator") {
  for (const auto& line : expected_lines("real_spheres.txt")) {
    REQUIRE(line.size() == 5);
    const auto file = test::shared_scene(line[0]);
    if (!file) continue;
    LoadOptions options;
    options.radius = std::stod(line[1]);
    CAPTURE(line[0]);
    const Scene scene = load_scene(*file, options);
    CHECK(scene.triangles().size() == std::stoull(line[2]));
    CHECK(scene.spheres().size() == std::stoull(line[3]));
    CHECK(scene.hash() == line[4]);
    check_sources(scene);
  }
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
