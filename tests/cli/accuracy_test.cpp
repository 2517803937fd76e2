// accuracy: every way is measured or says why not, what is wrong is found to be wrong, and nothing outlives
// it.

#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/cli/child.hpp"
#include "tests/point/hard_case.hpp"
#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/triangles.hpp"

using namespace provis;
using namespace provis::test;
using Json = nlohmann::json;

namespace {

std::string text(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

const HardCase& hard_case(const std::string& name) {
  static const std::vector<HardCase> cases = load_hard_cases(PROVIS_SOURCE_DIR "/data/hard");
  return *std::find_if(cases.begin(), cases.end(), [&](const HardCase& c) { return c.input.name == name; });
}

/// A case of the catalogue as a file, and the words that ask its question.
Words command(const HardCase& c, const TempFolder& folder) {
  const std::string scene = (folder.path() / "scene.ply").string();
  export_ply(Scene(c.input.arrays), scene);
  const PointView& view = c.input.view;
  const Frame& f = view.frames.front();
  Words words = {"accuracy", scene, "--runs", "1", "--size", "2x2", "--eye=" + text(view.eye)};
  if (view.projection == Projection::parallel) words = words + Words{"--view", "parallel"};
  return words +
         Words{"--right=" + text(f.right), "--up=" + text(f.up), "--forward=" + text(f.forward),
               fmt::format("--window={},{},{},{}", f.window.x0, f.window.x1, f.window.y0, f.window.y1)};
}

Words small_query(const TempFolder& folder, const std::string& runs = "1") {
  const std::string scene = write_small_scene(folder.path() / "s.ply");
  return {"accuracy", scene, "--runs", runs, "--eye", "0,0,0", "--dir", "0,0,-1", "--size", "8x8"};
}

/// One that takes MPFR a minute or more.
const Words slow_query = {"accuracy",
                          PROVIS_SOURCE_DIR "/data/demo/courtyard.ply",
                          "--runs",
                          "1",
                          "--eye=-5.5,1.7,7.5",
                          "--view",
                          "omni",
                          "--size",
                          "8x8"};

// A sanitized program cannot be limited.
const Words unlimited = PROVIS_SANITIZED ? Words{"--memory-limit", "0"} : Words{};

Json report(const Words& words) {
  const Outcome outcome = provis_run(words + unlimited + Words{"--json", "-"});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  return Json::parse(outcome.out);
}

Json way(const Json& report, const std::string& name) {
  for (const Json& way : report["ways"])
    if (way["name"] == name) return way;
  FAIL("no way called " + name);
  return {};
}

Json schema() {
  return Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/accuracy.schema.json"));
}

std::size_t missing(const std::vector<PrimitiveId>& from, const std::vector<PrimitiveId>& wanted) {
  std::vector<PrimitiveId> left;
  std::set_difference(wanted.begin(), wanted.end(), from.begin(), from.end(), std::back_inserter(left));
  return left.size();
}

/// The children of a process that still run.
std::vector<pid_t> children(pid_t parent) {
  std::ifstream list(fmt::format("/proc/{0}/task/{0}/children", parent));
  return {std::istream_iterator<pid_t>(list), {}};
}

bool runs_mpfr(pid_t pid) {
  return read_text(fmt::format("/proc/{}/cmdline", pid)).find("mpfr") != std::string::npos;
}

}  // namespace

TEST_CASE("the table has a row for every way, and the price of certainty last") {
  const TempFolder folder;
  const Outcome outcome = provis_run(small_query(folder) + unlimited);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  for (const char* name : {"\ndoubles ", "\nchain ", "\nmpfr ", "\nexact ", "\naggressive ", "\nsampled 1x1 ",
                           "\nsampled 256x256 "})
    CHECK_THAT(outcome.out, Catch::Contains(name));
  const std::string last = outcome.out.substr(outcome.out.rfind('\n', outcome.out.size() - 2) + 1);
  CHECK_THAT(last, Catch::StartsWith("certainty  ") && Catch::Contains("which gave the same set"));
}

TEST_CASE("certain ways miss nothing and take no wrong sign") {
  const TempFolder folder;
  const Json json = report(small_query(folder));
  CHECK(json["exact_set_by"] == "chain");
  CHECK(json["area"]["measure"] == "subdivision");
  for (const char* name : {"chain", "mpfr", "exact"}) {
    const Json row = way(json, name);
    REQUIRE(row["ending"] == "done");
    CHECK(row["visible"] == 2);
    CHECK(row["score"] == Json{{"wrong_in", 0}, {"wrong_out", 0}, {"set_missed", 0.0}, {"area_missed", 0.0}});
    CHECK(row["cpu_seconds"]["least"] <= row["cpu_seconds"]["median"]);
  }
  CHECK(way(json, "exact")["signs"]["exact"] > 0);
  CHECK(way(json, "mpfr")["signs"]["mpfr"] > 0);
  CHECK(way(json, "exact")["signs"]["filter"] == 0);
  CHECK(way(json, "doubles")["signs"]["wrong"] == 0);
}

TEST_CASE("where doubles are known to be wrong, the report says how") {
  const std::string name = GENERATE("coincident-triple", "nested-silhouettes", "staircase-one-ulp",
                                    "huge-1e150", "parallel-exact-shadow", "frame-skew");
  const HardCase& c = hard_case(name);
  INFO(name);
  REQUIRE(c.doubles);
  const TempFolder folder;
  const std::string file = (folder.path() / "report.json").string();
  const Outcome outcome = provis_run(command(c, folder) + unlimited + Words{"--json", file});
  REQUIRE(outcome.status == 0);
  const Json json = Json::parse(read_text(file));
  CHECK(schema_violations(schema(), json) == Words{});
  const std::size_t in = missing(c.visible, *c.doubles), out = missing(*c.doubles, c.visible);
  const Json doubles = way(json, "doubles");
  CHECK(doubles["signs"]["wrong"] > 0);
  CHECK(doubles["visible"] == c.doubles->size());
  CHECK(doubles["score"]["wrong_in"] == in);
  CHECK(doubles["score"]["wrong_out"] == out);
  CHECK(doubles["score"]["set_missed"] ==
        Approx(static_cast<double>(out) / static_cast<double>(c.visible.size())));
  for (const char* certain : {"chain", "mpfr", "exact"}) {
    CHECK(way(json, certain)["visible"] == c.visible.size());
    CHECK(way(json, certain)["score"]["wrong_in"] == 0);
    CHECK(way(json, certain)["score"]["wrong_out"] == 0);
  }
  CHECK(json["certainty"]["wrong_in"] == in);
  CHECK(json["certainty"]["wrong_out"] == out);
  CHECK_THAT(outcome.out, Catch::Contains(fmt::format("doubles gave another set ({} in, {} out)", in, out)));
}

TEST_CASE("what does not end in time is ended, and no more than that is lost") {
  const Json json = report(slow_query + Words{"--time-limit", "3"});
  CHECK(schema_violations(schema(), json) == Words{});
  CHECK(way(json, "mpfr")["ending"] == "timed out");
  CHECK(json["ways"].size() == 14);
}

TEST_CASE("if nothing ends in time, there is nothing to compare with") {
  const TempFolder folder;
  const Words words = small_query(folder) + Words{"--time-limit", "1e-9"};
  const Json json = report(words);
  CHECK(schema_violations(schema(), json) == Words{});
  for (const char* name : {"doubles", "chain", "mpfr", "exact", "aggressive", "sampled 1x1"})
    CHECK(way(json, name)["ending"] == "timed out");
  CHECK(way(json, "sampled 2x2")["ending"] == "not tried");
  CHECK(json["exact_set_by"].is_null());
  CHECK(json["area"]["measure"].is_null());
  CHECK(json["certainty"].is_null());
  CHECK_THAT(provis_run(words + unlimited).out,
             Catch::Contains("doubles          timed out\n") && Catch::Contains("certainty  not known"));
}

TEST_CASE("what takes too much memory says so") {
  if (PROVIS_SANITIZED) return;
  const TempFolder folder;
  const Json json = report(command(hard_case("staircase"), folder) + Words{"--memory-limit", "2M"});
  CHECK(schema_violations(schema(), json) == Words{});
  for (const char* name : {"doubles", "chain", "exact"}) CHECK(way(json, name)["ending"] == "out of memory");
}

TEST_CASE("what a signal ends is reported with the signal") {
  const TempFolder folder;
  // A result longer than any file may be ends the child; the report goes through a pipe.
  const Outcome outcome = provis_run(small_query(folder) + unlimited + Words{"--json", "-"},
                                     "{ ulimit -f 0; \"$0\" \"$@\"; } | cat; exit 0; true");
  INFO(outcome.err);
  const Json json = Json::parse(outcome.out);
  CHECK(schema_violations(schema(), json) == Words{});
  CHECK(way(json, "chain")["ending"] == "crashed");
  CHECK_THAT(way(json, "chain")["reason"].get<std::string>(),
             Catch::StartsWith(fmt::format("signal {}, ", SIGXFSZ)));
}

TEST_CASE("an interrupt ends the children too") {
  Child child(slow_query + Words{"--time-limit", "3600"} + unlimited);
  pid_t slow = 0;
  while (slow == 0) {
    for (const pid_t pid : children(child.pid()))
      if (runs_mpfr(pid)) slow = pid;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  kill(child.pid(), SIGINT);
  const Outcome outcome = child.wait();
  CHECK(outcome.status == 130);
  CHECK_THAT(outcome.err, Catch::Contains("interrupted"));
  CHECK(kill(slow, 0) != 0);
}

TEST_CASE("the children are asked what accuracy was asked") {
  const TempFolder folder;
  const std::string broken = write_broken_scene(folder.path() / "broken.ply");
  const Words words = {"accuracy", broken, "--runs", "1", "--eye", "0,0,0", "--dir=0,0,-1", "--size", "8x8"};
  CHECK(provis_run(words).status == 2);
  const Json json = report(words + Words{"--skip-invalid", "--sides", "both", "--perturb", "1e-8", "--seed",
                                         "3", "--threads", "1"});
  CHECK(schema_violations(schema(), json) == Words{});
  CHECK(json["query"]["sides"] == "both");
  CHECK(json["query"]["seed"] == "3");
  CHECK(json["query"]["size"] == "8x8");
  CHECK(json["threads"] == 1);
  // A child that had read another scene would have been found out by its hash.
  CHECK(way(json, "chain")["ending"] == "done");
  CHECK(way(json, "chain")["visible"] == 2);
}

TEST_CASE("the picture is SVG, and names what it leaves out") {
  const TempFolder folder;
  const std::string file = (folder.path() / "p.svg").string();
  REQUIRE(provis_run(small_query(folder) + unlimited + Words{"--picture", file}).status == 0);
  const std::string svg = read_text(file);
  CHECK_THAT(svg, Catch::StartsWith("<svg ") && Catch::EndsWith("</svg>\n"));
  CHECK_THAT(svg, Catch::Contains("nothing") && Catch::Contains("CPU time") && Catch::Contains(">chain<"));
  const Outcome late =
      provis_run(small_query(folder) + unlimited + Words{"--time-limit", "1e-9", "--picture", "-"});
  CHECK_THAT(late.out, Catch::Contains("Not shown: timed out: doubles, chain, mpfr, exact"));
}

TEST_CASE("options of accuracy that make no sense are refused before anything runs") {
  const TempFolder folder;
  const auto refused = [&](const Words& more, const char* message) {
    const Outcome outcome = provis_run(small_query(folder) + more);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    CHECK_THAT(outcome.err, Catch::Contains(message));
  };
  CHECK_THAT(provis_run(small_query(folder, "0")).err,
             Catch::Contains("--runs: expected a whole number from 1 to 1000, got \"0\""));
  CHECK(provis_run(small_query(folder, "1001")).status == 1);
  refused({"--time-limit", "0"}, "--time-limit: expected seconds above 0");
  refused({"--time-limit", "inf"}, "--time-limit: expected a finite number");
  refused({"--memory-limit", "5T"}, "--memory-limit: expected a whole number");
  refused({"--memory-limit", "99999999999G"}, "--memory-limit: expected a whole number");
  refused({"--threads", "-1"}, "--threads");
  refused({"--picture", "p.png"}, "--picture: writes SVG");
  refused({"--json", "-", "--picture", "-"}, "only one of --json and --picture");
  refused({"--fovy", "200"}, "--fovy");
  CHECK(provis_run(small_query(folder) + Words{"--json", "/nowhere/r.json"}).status == 4);
  CHECK(provis_run({"accuracy", "/nowhere.glb", "--eye", "0,0,0", "--dir", "0,0,-1"}).status == 2);
  CHECK(provis_run({"accuracy"}).status == 1);
}

TEST_CASE("along a segment every policy, both engines and numbers of viewpoints are compared") {
  const TempFolder folder;
  const std::string scene = write_small_scene(folder.path() / "s.ply");
  const Words words = {"accuracy", scene,  "--runs",   "1",      "--from",
                       "0,0,0",    "--to", "0.01,0,0", "--size", "8x8"};
  const std::string file = (folder.path() / "r.json").string(), svg = (folder.path() / "p.svg").string();
  const Outcome outcome = provis_run(words + unlimited + Words{"--json", file, "--picture", svg});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json json = Json::parse(read_text(file));
  CHECK(schema_violations(schema(), json) == Words{});
  CHECK(json["exact_set_by"] == "chain");
  CHECK(json["query"]["kind"] == "segment");
  CHECK(json["query"]["segments"].size() == 1);
  CHECK(json["area"]["measure"] == "sight");
  CHECK(json["ways"].size() == 13);
  for (const Json& w : json["ways"]) {
    INFO(w.dump());
    REQUIRE(w["ending"] == "done");
    CHECK(w["visible"] == 2);
    CHECK(w["score"] == Json{{"wrong_in", 0}, {"wrong_out", 0}, {"set_missed", 0.0}, {"area_missed", 0.0}});
  }
  CHECK(way(json, "exact (plain)")["signs"]["exact"] > 0);
  CHECK(way(json, "doubles")["signs"]["wrong"] == 0);
  CHECK(way(json, "doubles (plain)")["signs"]["wrong"].is_null());
  CHECK(way(json, "sampled 100000")["viewpoints"] == 100000);
  CHECK_THAT(outcome.out,
             Catch::Contains("which gave the same set") && Catch::Contains("sampling   100 % of the set"));
  CHECK_THAT(read_text(svg), Catch::Contains("viewpoints along the segment"));
  // A family stops where it is too slow, and says so.
  const Json late = report(words + Words{"--time-limit", "1e-9"});
  CHECK(way(late, "sampled 10")["ending"] == "timed out");
  CHECK(way(late, "sampled 100")["ending"] == "not tried");
  CHECK(way(late, "sampled 100000")["reason"] == way(late, "sampled 100")["reason"]);
  CHECK(schema_violations(schema(), late) == Words{});
}

TEST_CASE("along a segment a sight that is missed is measured") {
  // A wall behind a slit, seen for one two-thousandth of the way: none of ten viewpoints looks through.
  const TempFolder folder;
  SceneArrays arrays;
  const auto add = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) { add_triangle(arrays, a, b, c); };
  add({-90, -90, -2}, {0.001, -90, -2}, {0.001, 90, -2});
  add({0.002, -90, -2}, {90, -90, -2}, {0.002, 90, -2});
  add({-90, -90, -4}, {90, -90, -4}, {0, 90, -4});
  const std::string scene = (folder.path() / "gap.ply").string();
  export_ply(Scene(arrays), scene);
  const Json json = report({"accuracy", scene, "--runs", "1", "--from", "-1,0,0", "--to", "1,0,0", "--dir",
                            "0,0,-1", "--size", "1x1"});
  CHECK(way(json, "chain")["visible"] == 3);
  const Json ten = way(json, "sampled 10");
  CHECK(ten["visible"] == 2);
  CHECK(ten["score"]["wrong_out"] == 1);
  CHECK(ten["score"]["area_missed"].get<double>() == Approx(0.0005).epsilon(1e-6));
  CHECK(way(json, "sampled 10000")["score"]["wrong_out"] == 0);
}

TEST_CASE("a query is from a point, along segments or from a cell") {
  const TempFolder folder;
  const auto refused = [&](const Words& more, const char* message) {
    const Outcome outcome = provis_run(small_query(folder) + more);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Catch::Contains(message));
  };
  refused({"--from", "0,0,0", "--to", "1,0,0"}, "--eye: has no place along a segment");
  refused({"--faces", "6"}, "--faces");
  const std::string scene = write_small_scene(folder.path() / "t.ply");
  const auto along = [&](const Words& more) { return provis_run(Words{"accuracy", scene} + more); };
  CHECK_THAT(along({"--center", "0,0,0"}).err, Catch::Contains("--edge"));
  CHECK_THAT(along({"--center", "0,0,0", "--edge", "1", "--eye", "0,0,0"}).err,
             Catch::Contains("--eye: has no place with a cell"));
  CHECK_THAT(along({"--center", "0,0,0", "--edge", "1", "--to", "0,0,0"}).err, Catch::Contains("--to"));
  CHECK_THAT(along({"--from", "0,0,0"}).err, Catch::Contains("--to"));
  CHECK_THAT(along({"--rect", "0,0,0:1,0,0"}).err, Catch::Contains("--rect"));
  CHECK_THAT(along({"--from", "0,0,0", "--to", "1,0,0", "--view", "omni"}).err, Catch::Contains("--view"));
}

TEST_CASE(
    "from a cell both bounds are compared by resolution and viewpoints, and with a grid of viewpoints") {
  const TempFolder folder;
  const std::string scene = write_small_scene(folder.path() / "s.ply");
  const Words words = {"accuracy", scene,    "--runs", "1",      "--center",
                       "0,0,0",    "--edge", "0.25",   "--size", "16x16"};
  const std::string file = (folder.path() / "r.json").string();
  const Outcome outcome = provis_run(words + unlimited + Words{"--json", file});
  INFO(outcome.err);
  REQUIRE(outcome.status == 0);
  const Json json = Json::parse(read_text(file));
  CHECK(schema_violations(schema(), json) == Words{});
  CHECK(json["query"]["kind"] == "cell");
  CHECK(json["ways"].size() == 15);
  for (const Json& w : json["ways"]) {
    INFO(w.dump());
    REQUIRE(w["ending"] == "done");
    CHECK(w.contains("excess") == (w["method"] == "cos" || w["method"] == "bounds"));
    CHECK(w["score"].is_null() == (w["method"] == "cos"));
    if (w["method"] == "lower" || w["method"] == "bounds") CHECK(w["score"]["wrong_in"] == 0);
  }
  CHECK(json["known"]["visible"] == way(json, "bounds")["visible"]);
  CHECK(way(json, "sampled 216")["score"]["wrong_out"] == 0);
  CHECK_THAT(outcome.out, Catch::EndsWith("216 viewpoints miss 0 of what is proven visible, 0 in number\n"));
  // A camera's window does not follow the pixels of each way.
  const Json ahead = report(words + Words{"--dir", "0,0,-1"}),
             behind = report(words + Words{"--dir", "0,0,1"});
  CHECK(ahead["known"]["visible"] == json["known"]["visible"]);
  CHECK(behind["known"]["visible"] == 0);
  const Json late = report(words + Words{"--time-limit", "1e-9"});
  CHECK(late["known"].is_null());
  CHECK(way(late, "cos 50x25")["ending"] == "not tried");
  CHECK(way(late, "lower")["ending"] == "timed out");
  CHECK(schema_violations(schema(), late) == Words{});
}

TEST_CASE("a check is for plain doubles only") {
  const TempFolder folder;
  const Words words = {"point",  write_small_scene(folder.path() / "s.ply"), "--eye", "0,0,0", "--dir=0,0,-1",
                       "--check"};
  CHECK(provis_run(words).status == 1);
  CHECK(provis_run(words + Words{"--arithmetic", "doubles", "--subdivision"}).status == 1);
  const Outcome outcome = provis_run(words + Words{"--arithmetic", "doubles"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Contains("wrong      0 of these signs\n"));
}
