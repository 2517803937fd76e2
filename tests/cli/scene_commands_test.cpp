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
  CHECK_THAT(text.out,
             Catch::Contains("triangles  4 (1 of zero area, 0 duplicates)\nedges      9 (9 open)\n"));
  CHECK_THAT(text.out, Catch::Contains("vertices   9"));
  CHECK_THAT(text.out, Catch::Contains("extent     -2,-1,-3 to 1.5,1,-2"));
  CHECK_THAT(text.out, Catch::Contains(load_scene(file).hash()));
  CHECK_THAT(text.out, Catch::Contains("effect     spheres       left out"));
  CHECK_THAT(text.out, Catch::Contains("bytes per triangle, peak memory "));
  CHECK(text.out.back() == '\n');
}

TEST_CASE("info says how long loading took and what memory it needed, and nothing else varies") {
  const TempFolder directory;
  const std::string file = write_small_scene(directory.path() / "s.ply");
  auto a = nlohmann::json::parse(provis_run({"info", file, "--json"}).out),
       b = nlohmann::json::parse(provis_run({"info", file, "--json"}).out);
  CHECK(a["stats"]["load_seconds"] > 0);
  CHECK(a["stats"]["array_bytes"] == 9 * 24 + 4 * 13);
  CHECK(a["stats"]["bytes_per_triangle"] == 67);
  CHECK(a["stats"]["peak_resident_bytes"] > 1 << 20);
  a.erase("stats");
  b.erase("stats");
  CHECK(a == b);
}

TEST_CASE("info tells where a primitive is from") {
  const TempFolder directory;
  const std::string file = write_broken_scene(directory.path() / "s.ply");
  const Outcome text = provis_run({"info", file, "--skip-invalid", "--source", "2"});
  CHECK(text.status == 0);
  CHECK_THAT(text.out, Catch::Contains("element    face 4\n") && Catch::Contains("corner 0   0.5,-1,-2\n"));
  const auto json =
      nlohmann::json::parse(provis_run({"info", file, "--skip-invalid", "--source", "2", "--json"}).out);
  CHECK((json["element"] == 4 && json["element_name"] == "face"));
  const Outcome beyond = provis_run({"info", file, "--skip-invalid", "--source", "4"});
  CHECK(beyond.status == 1);
  CHECK_THAT(beyond.err, Catch::Contains("0 to 3"));
  const Outcome node = provis_run({"info", file, "--skip-invalid", "--ids-of", "0"});
  CHECK(node.status == 1);
  CHECK_THAT(node.err, Catch::Contains("no nodes"));
}

TEST_CASE("info lists what was left out") {
  const TempFolder directory;
  const std::string file = write_broken_scene(directory.path() / "s.ply");
  CHECK(provis_run({"info", file}).status == 2);
  const Outcome text = provis_run({"info", file, "--skip-invalid"});
  CHECK(text.status == 0);
  CHECK_THAT(text.out,
             Catch::Contains("left out   2 invalid primitives\n           line 21: face 2 uses vertex 9 "
                             "of 9\n           line 22: face 3 has no corners\n"));
  CHECK_THAT(text.out, Catch::Contains(", skip_invalid true\n"));
  const auto json = nlohmann::json::parse(provis_run({"info", file, "--skip-invalid", "--json"}).out);
  CHECK(json["scene"]["left_out"][1]["place"] == "line 22");
}

TEST_CASE("particles are measured, posed and exported") {
  const TempFolder directory;
  const std::string file = write_particles(directory.path() / "p.ply"),
                    out = (directory.path() / "x.ply").string();
  const Outcome text = provis_run({"info", file});
  CHECK_THAT(text.out, Catch::Contains("spheres    3 (1 of radius 0), radius 0 to 1\n"));
  CHECK_THAT(text.out, Catch::Contains("effect     spheres       needed    3 spheres\n"));
  LoadOptions later;
  later.time = 0.5;
  REQUIRE(provis_run({"export", file, "--time", "0.5", "--out", out}).status == 0);
  CHECK(load_scene(out).hash() == load_scene(file, later).hash());
  CHECK(load_scene(out).spheres()[1].center == Vec3d{1.5, 2, 2.5});
  const Outcome moved = provis_run({"info", file, "--time", "0.5", "--source", "1"});
  CHECK_THAT(moved.out,
             Catch::Contains("element    sphere 1\n") && Catch::Contains("centre     1.5,2,2.5\n"));
  const Outcome animated = provis_run({"info", file, "--time", "1", "--animation", "walk"});
  CHECK(animated.status == 1);
  CHECK_THAT(animated.err, Catch::Contains("--animation"));
}

TEST_CASE("points become spheres where a radius is stated") {
  const TempFolder directory;
  const std::string file = (directory.path() / "points.ply").string();
  std::ofstream(file) << "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                         "property float z\nend_header\n0 0 0\n1 1 1\n";
  CHECK_THAT(provis_run({"info", file}).out, Catch::Contains("skipped    2 points"));
  const Outcome spheres = provis_run({"info", file, "--radius", "0.25"});
  CHECK_THAT(spheres.out, Catch::Contains("spheres    2 (0 of radius 0), radius 0.25 to 0.25\n") &&
                              Catch::Contains("skipped    0 points") && Catch::Contains("radius 0.25,"));
}

TEST_CASE("export warns of what it leaves out") {
  const TempFolder directory;
  const std::string file = write_broken_scene(directory.path() / "s.ply"),
                    out = (directory.path() / "x.ply").string();
  const Outcome outcome = provis_run({"export", file, "--skip-invalid", "--out", out});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err,
             Catch::Contains("provis: warning: ") && Catch::Contains("line 21: face 2 uses vertex 9"));
  CHECK(load_scene(out).triangles().size() == 4);
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
