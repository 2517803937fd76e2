// What info says of a scene, as text and as JSON.

#include "src/report/scene_report.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>

#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using Json = nlohmann::json;

namespace {

/// Two triangles that share an edge, one of them see-through, a third of zero area, a double, two spheres.
SceneArrays arrays() {
  SceneArrays arrays;
  arrays.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0, 0}};
  arrays.triangles = {{0, 1, 2}, {1, 3, 2}, {0, 4, 1}, {2, 0, 1}};
  arrays.triangle_flags = {single_sided, see_through, single_sided, single_sided};
  arrays.spheres = {{{5, 5, 5}, 0.25}, {{5, 5, 5}, 2}};
  arrays.sphere_flags = {single_sided, single_sided};
  SourceRange first, second;
  first.count = 4;
  first.node = 3;
  second.first = 4;
  second.count = 2;
  second.node = 3;
  second.instance = 0;
  arrays.sources = {first, second};
  arrays.notes.format = "glTF";
  arrays.notes.unit = "metre";
  arrays.notes.scenes = {"", "night"};
  arrays.notes.scene = 1;
  arrays.notes.animations = {{"walk", 0, 2.5, 0}, {"", 0.5, 1, 3}};
  arrays.notes.animation = 3;
  arrays.skipped = {7, 8};
  return arrays;
}

SceneInfo info_of(const Scene& scene) {
  SceneInfo info;
  info.file = "a house.glb";
  info.options = {{"sides", "material"}, {"time", "0.75"}};
  info.counts = summarize(scene);
  info.topology = topology(scene);
  info.effects = plan_effects(scene, Projection::pinhole);
  info.cost = {0.125, 3 << 20};
  return info;
}

std::string text_of(const SceneArrays& arrays) {
  const Scene scene(arrays);
  return scene_text(scene, info_of(scene));
}

Json json_of(const SceneArrays& arrays) {
  const Scene scene(arrays);
  std::stringstream out;
  write_scene_json(scene, info_of(scene), out);
  CHECK(out.str().back() == '\n');
  return Json::parse(out.str());
}

Json schema() {
  return Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/scene-info.schema.json"));
}

}  // namespace

TEST_CASE("the text holds every count, a line each") {
  const std::string text = text_of(arrays());
  for (const char* line :
       {"scene      a house.glb\n", "options    sides material, time 0.75\n", "format     glTF, unit metre\n",
        "loaded     scene 1 \"night\" of 2\n", "animation  0 \"walk\", 0 to 2.5 s, not applied\n",
        "animation  3, 0.5 to 1 s, applied\n", "triangles  4 (1 of zero area, 1 duplicates)\n",
        "edges      5 (2 open)\n", "spheres    2 (0 of radius 0), radius 0.25 to 2\n", "vertices   5\n",
        "extent     0,0,0 to 7,7,7\n", "material   single-sided, opaque       3 triangles, 2 spheres\n",
        "material   two-sided, see-through     1 triangles, 0 spheres\n",
        "sources    2 runs of ids from 1 nodes\n", "skipped    7 points, 8 lines\n", "effect     spheres",
        "load       0.125 s, 59.5 bytes per triangle, peak memory 3.0 MiB\n"})
    CHECK_THAT(text, Catch::Contains(line));
  CHECK(text.back() == '\n');
  CHECK_THAT(text, !Catch::Contains("left out   "));
  CHECK_THAT(text, !Catch::Contains("single-sided, see-through"));
}

TEST_CASE("an animation that is applied is told even if the file does not declare its times") {
  SceneArrays unlisted = arrays();
  unlisted.notes.animation = 5;
  const std::string text = text_of(unlisted);
  CHECK_THAT(text,
             Catch::Contains("animation  5, applied\n") && Catch::Contains("0.5 to 1 s, not applied\n"));
  CHECK(json_of(unlisted)["applied_animation"] == 5);
  unlisted.notes.animation = -1;
  CHECK_THAT(text_of(unlisted), !Catch::Contains(", applied"));
  CHECK(json_of(unlisted)["applied_animation"].is_null());
}

TEST_CASE("a scene without triangles, nodes or notes is told without them") {
  SceneArrays points;
  points.notes.format = "PLY";
  const std::string text = text_of(points);
  CHECK_THAT(text, Catch::Contains("format     PLY, unit unknown\n"));
  CHECK_THAT(text, Catch::Contains("spheres    0 (0 of radius 0)\n"));
  CHECK_THAT(text, Catch::Contains("load       0.125 s, peak memory"));
  for (const char* absent : {"loaded  ", "animation", "material  ", "nodes", "bytes per triangle"})
    CHECK_THAT(text, !Catch::Contains(absent));
  CHECK(json_of(points)["stats"]["bytes_per_triangle"].is_null());
  CHECK(json_of(points)["radius"].is_null());
}

TEST_CASE("of what was left out the text shows the first ten, JSON all") {
  SceneArrays many = arrays();
  for (int i = 0; i < 12; ++i) many.left_out.push_back({"line " + std::to_string(100 + i), "broken"});
  const std::string text = text_of(many);
  CHECK_THAT(text, Catch::Contains("left out   12 invalid primitives\n           line 100: broken\n"));
  CHECK_THAT(text, Catch::Contains("line 109: broken\n           and 2 more"));
  CHECK_THAT(text, !Catch::Contains("line 110"));
  const Json left_out = json_of(many)["scene"]["left_out"];
  REQUIRE(left_out.size() == 12);
  CHECK(left_out[11] == Json{{"place", "line 111"}, {"reason", "broken"}});
}

TEST_CASE("JSON holds the same, and obeys its schema") {
  const Json json = json_of(arrays());
  CHECK(schema_violations(schema(), json) == std::vector<std::string>{});
  CHECK(json["degenerate"]["triangles"] == 1);
  CHECK(json["duplicate_triangles"] == 1);
  CHECK(json["edges"] == Json{{"total", 5}, {"open", 2}});
  CHECK(json["radius"] == Json{{"smallest", 0.25}, {"largest", 2.0}});
  CHECK(json["materials"]["triangles"]["single_sided_opaque"] == 3);
  CHECK(json["materials"]["triangles"]["two_sided_see_through"] == 1);
  CHECK(json["materials"]["spheres"]["single_sided_opaque"] == 2);
  CHECK(json["unit"] == "metre");
  CHECK(json["scenes"][1] == Json{{"index", 1}, {"name", "night"}, {"loaded", true}});
  CHECK(json["animations"][0]["applied"] == false);
  CHECK(json["animations"][1]["index"] == 3);
  CHECK(json["animations"][1]["applied"] == true);
  CHECK(json["options"]["time"] == "0.75");
  REQUIRE(json["sources"].size() == 2);
  CHECK(json["sources"][0]["last"] == 3);
  CHECK(json["sources"][0]["instance"].is_null());
  CHECK(json["sources"][1]["instance"] == 0);
  CHECK(schema_violations(schema(), json_of([] {
                            SceneArrays empty;
                            empty.notes.format = "PLY";
                            return empty;
                          }())) == std::vector<std::string>{});
}

TEST_CASE("the schema of a scene's description notices damage") {
  const Json good = json_of(arrays()), rules = schema();
  const auto damaged = [&](const char* pointer, const Json& value) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    return !schema_violations(rules, bad).empty();
  };
  CHECK(damaged("/version", 2));
  CHECK(damaged("/radius", 3));
  CHECK(damaged("/unit", 3));
  CHECK(damaged("/edges/open", -1));
  CHECK(damaged("/sources/0/node", "door"));
  CHECK(damaged("/sources/0/per_element", 0));
  CHECK(damaged("/surplus", 1));
  for (const Json& key : rules["required"]) {
    Json bad = good;
    bad.erase(key.get<std::string>());
    CHECK_FALSE(schema_violations(rules, bad).empty());
  }
}

TEST_CASE("only stats differ between two descriptions of one scene") {
  const Scene scene(arrays());
  SceneInfo slow = info_of(scene);
  slow.cost = {99, 1};
  std::stringstream a, b;
  write_scene_json(scene, info_of(scene), a);
  write_scene_json(scene, slow, b);
  Json first = Json::parse(a.str()), second = Json::parse(b.str());
  CHECK(first != second);
  first.erase("stats");
  second.erase("stats");
  CHECK(first == second);
}
