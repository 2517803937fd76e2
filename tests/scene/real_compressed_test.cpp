// Published scenes under EXT_meshopt_compression and KHR_draco_mesh_compression have the counts and boxes
// that the list beside them states.
#include <catch2/catch.hpp>
#include <cstdio>
#include <sstream>

#include "tests/scene/files.hpp"
#include "tests/support/environment.hpp"

namespace provis {
namespace {

struct Listed {
  std::size_t triangles = 0;
  std::string box;
};

/// The row of that scene.
Listed listed(const std::string& name) {
  std::istringstream lines(read_text(test::shared_scenes_folder() / "README.md"));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| " + name + " |", 0) != 0) continue;
    std::vector<std::string> fields;
    std::istringstream row(line);
    for (std::string field; std::getline(row, field, '|');) fields.push_back(field);
    REQUIRE(fields.size() > 11);
    return {std::stoull(fields[5]), fields[11]};
  }
  FAIL("no row for " << name);
  return {};
}

/// As the list writes it: four digits.
std::string box(const SceneSummary& summary) {
  const Vec3d &a = summary.lower, &b = summary.upper;
  char text[200];
  std::snprintf(text, sizeof text, " (%.4g,%.4g,%.4g)..(%.4g,%.4g,%.4g) ", a.x, a.y, a.z, b.x, b.y, b.z);
  return text;
}

void check_listed(const std::string& name) {
  const auto file = test::shared_scene(name);
  if (!file) return;
  CAPTURE(name);
  const SceneSummary summary = summarize(load_scene(*file));
  CHECK(summary.triangles == listed(name).triangles);
  CHECK(box(summary) == listed(name).box);
}

TEST_CASE("published meshopt scenes have the listed counts and boxes") {
  check_listed("dream_apartment");
  check_listed("ww2_cityscene");
  check_listed("gt_BoxMeshopt");
  check_listed("pipeline_meshopt_nofallback");
}

TEST_CASE("a published meshopt scene has lines, too, which reach out of its triangles' box on one side") {
  const auto file = test::shared_scene("hotel_room");
  if (!file) return;
  const Scene scene = load_scene(*file);
  const SceneSummary summary = summarize(scene);
  CHECK(scene.skipped().lines == 20665);
  CHECK(summary.triangles == listed("hotel_room").triangles);
  const std::string of_triangles = box(summary), of_all = listed("hotel_room").box;
  CHECK(of_triangles.substr(of_triangles.find(',')) == of_all.substr(of_all.find(',')));
  CHECK(summary.lower.x > std::stod(of_all.substr(2)));
}

TEST_CASE("published Draco scenes have the listed counts and boxes") {
  check_listed("pc_heart_draco");
  check_listed("gt_DracoSparseMesh");
  check_listed("tile_frankfurt");
  check_listed("khr_2CylinderEngine_draco");
  check_listed("pc_cave");
  check_listed("pc_cave_collision");
  check_listed("pc_chess_board");
}

}  // namespace
}  // namespace provis
