// cell: the answer, the files it is written to, and what is refused.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "provis/cell.hpp"
#include "provis/result_file.hpp"
#include "tests/cli/child.hpp"
#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;
using Json = nlohmann::json;

namespace {

struct CellRun {
  TempFolder directory;
  std::string scene = write_small_scene(directory.path() / "s.ply");
  Words words = {"cell", scene, "--center", "0,0,0", "--edge", "0.25"};

  std::string path(const std::string& name) const { return (directory.path() / name).string(); }
  Outcome run(const Words& more) const { return provis_run(words + more); }
};

CellSet expected(const std::string& scene, const CellOptions& options = {},
                 const std::optional<Frame>& window = {}) {
  ViewCell cell = cell_around({0, 0, 0}, {0.25, 0.25, 0.25});
  cell.window = window;
  return visible_from_cell(load_scene(scene), cell, options);
}

std::vector<std::string> violations(const std::string& file) {
  const Json schema =
      Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
  return schema_violations(schema, Json::parse(read_text(file)));
}

}  // namespace

TEST_CASE("cell: the result file is what the library computes, reads back, and obeys the schema") {
  const CellRun query;
  const Outcome outcome = query.run({"--out", query.path("r.json"), "--ids", query.path("ids"), "--witness"});
  REQUIRE(outcome.status == 0);
  const ResultFile result = read_result(query.path("r.json"));
  const CellSet set = expected(query.scene);
  CHECK(result.set.status == set.set.status);
  CHECK(result.set.guarantee == set.set.guarantee);
  CHECK(result.set.answers == "R9");
  CHECK(result.set.witnesses.size() == set.set.witnesses.size());
  REQUIRE(result.header.cell);
  CHECK(result.header.cell->lower == Vec3d{-0.125, -0.125, -0.125});
  CHECK(result.header.cell->upper == Vec3d{0.125, 0.125, 0.125});
  REQUIRE(result.counts);
  CHECK(result.counts->offset.beams == set.offset.beams);
  CHECK(result.counts->bounds.viewpoints == set.bounds.viewpoints);
  CHECK(violations(query.path("r.json")) == std::vector<std::string>{});
}

TEST_CASE("cell: the camera offset space alone is conservative, and its ids are all that is not hidden") {
  const CellRun query;
  REQUIRE(query
              .run({"--method", "cos", "--cos-size", "6x4", "--out", query.path("r.json"), "--ids",
                    query.path("ids")})
              .status == 0);
  CHECK(violations(query.path("r.json")) == std::vector<std::string>{});
  CellOptions options;
  options.method = CellMethod::cos;
  options.pixels = {6, 4};
  const CellSet set = expected(query.scene, options);
  const ResultFile result = read_result(query.path("r.json"));
  CHECK(result.set.guarantee == Guarantee::conservative);
  CHECK(result.set.status == set.set.status);
  REQUIRE(result.counts);
  CHECK(result.counts->offset.lists == set.offset.lists);
  CHECK(result.counts->offset.signs_interval == set.offset.signs_interval);
  CHECK(result.counts->offset.seconds_lists > 0);
  std::string ids;
  for (std::size_t id = 0; id < set.set.status.size(); ++id)
    if (set.set.status[id] != Status::hidden) ids += std::to_string(id) + "\n";
  CHECK(read_text(query.path("ids")) == ids);
}

TEST_CASE("cell: samples answer another rule, with witnesses that are verified") {
  const CellRun query;
  const Outcome outcome =
      query.run({"--method", "cos-exact", "--cos-size", "3x3", "--witness", "--out", query.path("r.json")});
  REQUIRE(outcome.status == 0);
  CHECK(violations(query.path("r.json")) == std::vector<std::string>{});
  const ResultFile result = read_result(query.path("r.json"));
  CHECK(result.set.answers == "R10");
  CHECK(result.set.guarantee == Guarantee::exact);
  CHECK(result.set.witnesses.size() + result.boundary.size() == result.set.with(Status::visible).size());
  CHECK(result.counts->bounds.samples_used == 6 * (9 + 4 * 6));
  CHECK(query.run({"--method", "cos-exact", "--edge", "0"}).status != 0);
}

TEST_CASE("cell: a direction limits what is looked at, in every stage") {
  const CellRun query;
  REQUIRE(
      query.run({"--dir", "0,0,-1", "--window", "-1,0.5,-0.25,1", "--out", query.path("r.json")}).status ==
      0);
  CHECK(violations(query.path("r.json")) == std::vector<std::string>{});
  const ResultFile result = read_result(query.path("r.json"));
  REQUIRE(result.header.cell);
  REQUIRE(result.header.cell->window);
  CHECK(result.header.cell->window->window == Window{-1, 0.5, -0.25, 1});
  CHECK(result.set.status == expected(query.scene, {}, result.header.cell->window).set.status);
  CHECK(result.counts->offset.rasters <= 5);
  CHECK(result.counts->bounds.samples_used > 0);
  CHECK(query.run({"--window", "-1,1,-1,1"}).status == 1);
  CHECK(query.run({"--dir", "0,0,-1", "--fovy", "30", "--window", "-1,1,-1,1"}).status == 1);
}

TEST_CASE("cell: counters and times of the stages are printed when asked for") {
  const Outcome outcome = CellRun().run({"--stats"});
  CHECK(outcome.status == 0);
  for (const char* name : {"list_entries", "list_average", "kept_open_edge", "signs_interval", "resolve"})
    CHECK_THAT(outcome.out, Catch::Contains(name));
}

TEST_CASE("cell: the summary holds the answer and how it was found") {
  const Outcome outcome = CellRun().run({});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Contains("cell from -0.125,-0.125,-0.125 to 0.125,0.125,0.125"));
  CHECK_THAT(outcome.out, Catch::Contains("answers R9"));
  CHECK_THAT(outcome.out, Catch::Contains("proven by"));
}

TEST_CASE("cell: threads change nothing but stats") {
  const CellRun query;
  Json first;
  for (const char* threads : {"1", "2", "7"}) {
    const Outcome outcome = query.run({"--threads", threads, "--witness", "--out", query.path("r.json")});
    REQUIRE(outcome.status == 0);
    Json result = Json::parse(read_text(query.path("r.json")));
    result.erase("stats");
    if (first.is_null()) first = result;
    CHECK(result == first);
  }
}

TEST_CASE("cell: options that make no sense are refused") {
  const CellRun query;
  CHECK(provis_run({"cell", query.scene, "--edge", "1"}).status == 1);
  CHECK(provis_run({"cell", query.scene, "--center", "0,0,0", "--edge", "-1"}).status == 1);
  CHECK(provis_run({"cell", query.scene, "--center", "0,0,0", "--edge", "1,2"}).status == 1);
  CHECK(query.run({"--cos-size", "2048x16"}).status == 1);
  CHECK(query.run({"--method", "exact"}).status == 1);
  CHECK(query.run({"--out", "-", "--ids", "-"}).status == 1);
  CHECK(query.run({"--grid", "3"}).err.find("--grid") != std::string::npos);
  CHECK(query.run({"--size", "8x8"}).status == 1);
  CHECK(query.run({"--method", "sampled", "--grid", "0"}).status == 1);
  CHECK(query.run({"--method", "sampled", "--witness"}).status == 1);
}

TEST_CASE("cell: a grid of viewpoints, and its result says that it proves nothing") {
  const CellRun query;
  const Words how = {"--method", "sampled", "--grid", "3", "--size", "20x10"};
  REQUIRE(query.run(how + Words{"--out", query.path("r.json")}).status == 0);
  const ResultFile result = read_result(query.path("r.json"));
  const ViewCell cell = cell_around({0, 0, 0}, {0.25, 0.25, 0.25});
  CHECK(result.set.status == sampled_from_cell(load_scene(query.scene), cell, 3, {20, 10}).set.status);
  CHECK(result.set.guarantee == Guarantee::sampled);
  CHECK(result.header.options.at("grid") == "3");
  CHECK(violations(query.path("r.json")) == std::vector<std::string>{});
  CHECK(query.run(how).out.find("27 viewpoints; nothing is proven") != std::string::npos);
}
