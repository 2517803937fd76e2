// info and export.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "provis/scene.hpp"
#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;

TEST_CASE("info tells what the scene holds") {
  const TempFolder directory;
  const std::string file = write_small_scene(directory.path() / "s.ply");
  const Outcome text = provis_run({"info", file});
  CHECK(text.status == 0);
  CHECK(text.err.empty());
  CHECK_THAT(text.out, Catch::Contains("triangles  4 (1 of zero area)"));
  CHECK_THAT(text.out, Catch::Contains("vertices   9"));
  CHECK_THAT(text.out, Catch::Contains("extent     -2,-1,-3 to 1.5,1,-2"));
  CHECK_THAT(text.out, Catch::Contains(load_scene(file).hash()));
  CHECK_THAT(text.out, Catch::Contains("effect     spheres       left out"));
}

TEST_CASE("info as JSON holds the same") {
  const TempFolder directory;
  const std::string file = write_small_scene(directory.path() / "s.ply");
  const Outcome outcome = provis_run({"info", file, "--json", "--sides", "both"});
  CHECK(outcome.status == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["format"] == "provis.scene-info");
  CHECK(json["scene"]["triangles"] == 4);
  CHECK(json["scene"]["hash"] == load_scene(file, {Sides::both, Opacity::material}).hash());
  CHECK(json["degenerate"]["triangles"] == 1);
  CHECK(json["effects"].size() == 4);
}

TEST_CASE("an exported scene has the hash of its source, perturbed or not") {
  const TempFolder directory;
  const std::string file = write_small_scene(directory.path() / "s.ply"),
                    out = (directory.path() / "x.ply").string();
  REQUIRE(provis_run({"export", file, "--out", out}).status == 0);
  CHECK(load_scene(out).hash() == load_scene(file).hash());
  REQUIRE(provis_run({"export", file, "--out", out, "--perturb", "1e-8", "--seed", "5"}).status == 0);
  CHECK(load_scene(out).hash() == perturb(load_scene(file), 1e-8, 5).hash());
  CHECK(load_scene(out).hash() != load_scene(file).hash());
}
