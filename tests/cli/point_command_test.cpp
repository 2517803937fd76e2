// point: the answer, the files it is written to, and what may differ between runs.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "provis/point.hpp"
#include "provis/result_file.hpp"
#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;
using Json = nlohmann::json;

namespace {

// A query with the scene it needs.
struct Query {
  TempFolder directory;
  std::string scene = write_small_scene(directory.path() / "s.ply");
  Words words = {"point", scene, "--eye", "0,0,0", "--dir", "0,0,-1"};

  std::string path(const std::string& name) const { return (directory.path() / name).string(); }
  Outcome run(const Words& more) const { return provis_run(words + more); }
};

}  // namespace

TEST_CASE("the summary fits on a screen and holds the answer") {
  const Query query;
  const Outcome outcome = query.run({});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 10);
  CHECK_THAT(outcome.out, Catch::Contains("visible    2 (50 %)"));
  CHECK_THAT(outcome.out, Catch::Contains("hidden     2\n"));
  CHECK_THAT(outcome.out, Catch::Contains("undecided  0\n"));
  CHECK_THAT(outcome.out, Catch::Contains("guarantee  exact, answers R7"));
}

TEST_CASE("the result file is what the library computes, and the ids are its visible list") {
  const Query query;
  const Outcome outcome = query.run({"--out", query.path("r.json"), "--ids", query.path("ids")});
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.empty());
  const ResultFile result = read_result(query.path("r.json"));
  const Scene scene = load_scene(query.scene);
  LookAt camera;
  camera.direction = {0, 0, -1};
  const VisibleSet expected = visible_from_point(scene, look_at(camera));
  CHECK(result.set.status == expected.status);
  CHECK(result.set.with(Status::visible) == std::vector<PrimitiveId>{0, 2});
  CHECK(result.header.scene_file == query.scene);
  CHECK(result.header.scene_hash == scene.hash());
  CHECK(result.header.view.frames == look_at(camera).frames);
  CHECK(result.header.options == std::map<std::string, std::string>{{"arithmetic", "chain"},
                                                                    {"method", "exact"},
                                                                    {"opacity", "material"},
                                                                    {"perturb", "0"},
                                                                    {"seed", "0"},
                                                                    {"sides", "material"}});
  CHECK(read_text(query.path("ids")) == "0\n2\n");
}

TEST_CASE("threads change nothing but stats") {
  const Query query;
  Json first;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = query.run({"--threads", threads, "--witness", "--subdivision", "--out", "-"});
    REQUIRE(outcome.status == 0);
    Json json = Json::parse(outcome.out);
    CHECK(json["stats"]["threads"] == std::stoi(threads));
    CHECK(json["witnesses"].size() == 2);
    CHECK(json["subdivision"].size() > 0);
    json.erase("stats");
    if (first.is_null()) first = json;
    CHECK(json == first);
  }
}

TEST_CASE("every certain arithmetic gives the same set, and doubles claim nothing") {
  const Query query;
  for (const char* arithmetic : {"chain", "mpfr", "exact"}) {
    const Outcome outcome = query.run({"--arithmetic", arithmetic, "--ids", "-"});
    CHECK(outcome.status == 0);
    CHECK(outcome.out == "0\n2\n");
  }
  CHECK(Json::parse(query.run({"--arithmetic", "doubles", "--out", "-"}).out)["guarantee"] == "sampled");
}

TEST_CASE("the methods that look along rays say what they claim, where they looked, and with what") {
  const Query query;
  const Json aggressive =
      Json::parse(query.run({"--method", "aggressive", "--size", "8x6", "--out", "-"}).out);
  CHECK(aggressive["guarantee"] == "aggressive");
  CHECK(aggressive["visible"] == Json({0, 2}));
  CHECK(aggressive["counts"]["hidden"] == 0);
  CHECK(aggressive["query"]["size"] == "8x6");
  CHECK(aggressive["stats"]["sampling"]["pixels"] == 48);
  const Json sampled = Json::parse(
      query.run({"--method", "sampled", "--samples", "3", "--size", "8x6", "--witness", "--out", "-"}).out);
  CHECK(sampled["guarantee"] == "aggressive");
  CHECK(sampled["query"]["samples"] == "3");
  CHECK(sampled["stats"]["sampling"]["locations"] == 432);
  CHECK(sampled["witnesses"].size() == sampled["counts"]["visible"]);
}

TEST_CASE("the paper's engine gives the same set, says that it was asked, and counts") {
  const Query query;
  const Json json = Json::parse(query.run({"--engine", "paper", "--out", "-"}).out);
  CHECK(json["guarantee"] == "exact");
  CHECK(json["visible"] == Json({0, 2}));
  CHECK(json["query"]["engine"] == "paper");
  CHECK(json["stats"]["iteration"]["visible"] == 2);
  CHECK_THAT(query.run({"--engine", "paper"}).out, Catch::Contains("aggressive 100 % of the set"));
  CHECK_THAT(query.run({"--engine", "paper", "--stats", "--ids", "-"}).err, Catch::Contains("sampling   "));
}

TEST_CASE("options that do not go together are refused by name") {
  const Query query;
  for (const Words& words : {Words{"--samples", "2"}, Words{"--method", "sampled", "--samples", "257"},
                             Words{"--method", "aggressive", "--engine", "paper"},
                             Words{"--method", "aggressive", "--subdivision"}}) {
    INFO(words.back());
    CHECK(query.run(words).status == 1);
  }
}

TEST_CASE("a frame given verbatim is recorded verbatim") {
  const Query query;
  const Outcome outcome =
      provis_run({"point", query.scene, "--eye", "0.1,0,0", "--right", "1,0,0.1", "--up", "0,2,0",
                  "--forward", "0,0,-3", "--window", "-1,1,-0.5,0.5", "--out", query.path("r.json")});
  REQUIRE(outcome.status == 0);
  const ResultFile result = read_result(query.path("r.json"));
  CHECK(result.header.view.eye == Vec3d{0.1, 0, 0});
  CHECK(result.header.view.frames ==
        std::vector<Frame>{Frame{{1, 0, 0.1}, {0, 2, 0}, {0, 0, -3}, {-1, 1, -0.5, 0.5}}});
}

TEST_CASE("omni and parallel views") {
  const Query query;
  const Outcome around = provis_run({"point", query.scene, "--eye", "0,0,0", "--view", "omni", "--ids", "-"});
  CHECK(around.status == 0);
  CHECK(around.out == "0\n2\n");
  const Outcome parallel = query.run({"--view", "parallel", "--window", "-2,2,-2,2", "--ids", "-"});
  CHECK(parallel.status == 0);
  CHECK(parallel.out == "0\n2\n");
}

TEST_CASE("a named view is the view that it names") {
  const Query query;
  std::ofstream(query.path("views.json"))
      << R"([{"scene": "s.ply", "name": "v", "eye": [0, 0, 0], "dir": [0, 0, -1], "up": [0, 1, 0], "fovy_deg": 60}])";
  const Outcome named =
      provis_run({"point", query.scene, "--views", query.path("views.json") + ":v", "--out", "-"});
  REQUIRE(named.status == 0);
  Json a = Json::parse(named.out), b = Json::parse(query.run({"--out", "-"}).out);
  a.erase("stats");
  b.erase("stats");
  CHECK(a == b);
}

TEST_CASE("a perturbed query says so") {
  const Query query;
  const Json json = Json::parse(query.run({"--perturb", "1e-8", "--seed", "3", "--out", "-"}).out);
  CHECK(json["query"]["perturb"] == "1e-08");
  CHECK(json["query"]["seed"] == "3");
  CHECK(json["scene"]["hash"] == perturb(load_scene(query.scene), 1e-8, 3).hash());
}

TEST_CASE("a result says what was left out, and how the scene was loaded") {
  const Query query;
  const std::string broken = write_broken_scene(query.directory.path() / "broken.ply");
  const Words words = {"point", broken, "--eye", "0,0,0", "--dir", "0,0,-1"};
  CHECK(provis_run(words).status == 2);
  const Outcome summary = provis_run(words + Words{"--skip-invalid"});
  CHECK(summary.status == 0);
  CHECK_THAT(summary.out, Catch::Contains("left out   2 invalid primitives\n"));
  CHECK(std::count(summary.out.begin(), summary.out.end(), '\n') == 11);
  CHECK_THAT(summary.err, Catch::Contains("warning: " + broken + ": left out 2 invalid primitives\n") &&
                              Catch::Contains("line 21: face 2 uses vertex 9 of 9\n"));
  const Json json =
      Json::parse(provis_run(words + Words{"--skip-invalid", "--radius", "0.1", "--out", "-"}).out);
  CHECK(json["visible"] == Json::array({0, 2}));
  CHECK(json["scene"]["left_out"].size() == 2);
  CHECK(json["scene"]["left_out"][0] == Json{{"place", "line 21"}, {"reason", "face 2 uses vertex 9 of 9"}});
  CHECK(json["query"]["skip_invalid"] == "true");
  CHECK(json["query"]["radius"] == "0.1");
  CHECK_FALSE(Json::parse(query.run({"--out", "-"}).out)["scene"].contains("left_out"));
}

TEST_CASE("of many that were left out the warning shows the first few") {
  const Query query;
  const std::string file = query.path("many.ply");
  std::ofstream(file)
      << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
         "property float z\nelement face 9\nproperty list uchar int vertex_indices\nend_header\n"
         "0 0 0\n0\n0\n0\n0\n0\n0\n0\n0\n0\n";
  const Outcome outcome =
      provis_run({"point", file, "--skip-invalid", "--eye", "0,0,0", "--view", "omni", "--ids", "-"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 5);
  CHECK_THAT(outcome.err, Catch::Contains("and 6 more"));
}

TEST_CASE("talk gives way to a result on standard output") {
  const Query query;
  const Outcome piped = query.run({"--ids", "-", "--stats", "--effects"});
  CHECK(piped.out == "0\n2\n");
  CHECK_THAT(piped.err, Catch::Contains("predicate") && Catch::Contains("effect     single-sided"));
  const Outcome shown = query.run({"--stats", "--effects"});
  CHECK(shown.err.empty());
  CHECK_THAT(shown.out, Catch::Contains("predicate") && Catch::Contains("effect     single-sided"));
}
