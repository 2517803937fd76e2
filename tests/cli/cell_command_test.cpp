// cell: the answer, the files it is written to, and what is refused.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

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

CellSet expected(const std::string& scene) {
  return visible_from_cell(load_scene(scene), cell_around({0, 0, 0}, {0.25, 0.25, 0.25}));
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
  const Json schema =
      Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
  CHECK(schema_violations(schema, Json::parse(read_text(query.path("r.json")))) ==
        std::vector<std::string>{});
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
}
