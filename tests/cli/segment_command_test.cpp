// segment: the answer, the files it is written to, and what the command line refuses.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "provis/result_file.hpp"
#include "tests/cli/child.hpp"
#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;
using Json = nlohmann::json;

namespace {

struct SegmentRun {
  TempFolder directory;
  std::string scene = write_small_scene(directory.path() / "s.ply");
  Words words = {"segment", scene, "--size", "16x16"};

  std::string path(const std::string& name) const { return (directory.path() / name).string(); }
  Outcome run(const Words& more) const { return provis_run(words + more); }
  Outcome along(const Words& more) const { return run(Words{"--from", "0,0,0", "--to", "0.01,0,0"} + more); }
};

}  // namespace

TEST_CASE("segment: the summary holds the answer") {
  const SegmentRun query;
  const Outcome outcome = query.along({});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK_THAT(outcome.out, Catch::Contains("visible    2 (50 %)"));
  CHECK_THAT(outcome.out, Catch::Contains("boundary   0 of them\n"));
  CHECK_THAT(outcome.out, Catch::Contains("guarantee  exact, answers R10"));
  CHECK_THAT(outcome.out, Catch::Contains("6 frames of 16x16 pixels"));
}

TEST_CASE("segment: the result file reads back, obeys the schema and can be drawn") {
  const SegmentRun query;
  const Outcome outcome = query.along(
      {"--witness", "--out", query.path("r.json"), "--ids", query.path("ids"), "--rank", query.path("rank")});
  REQUIRE(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Contains("verified   2 witnesses"));
  const ResultFile result = read_result(query.path("r.json"));
  CHECK(result.set.with(Status::visible) == std::vector<PrimitiveId>{0, 2});
  CHECK(result.set.answers == "R10");
  CHECK(result.boundary.empty());
  CHECK(result.set.witnesses.size() == 2);
  REQUIRE(result.header.segments);
  CHECK(result.header.segments->paths.size() == 1);
  CHECK(result.header.segments->frames.size() == 6);
  CHECK(result.header.segments->pixels.width == 16);
  CHECK(read_text(query.path("ids")) == "0\n2\n");
  REQUIRE(result.seen.size() == 2);

  const Json written = Json::parse(read_text(query.path("r.json")));
  const Json schema =
      Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
  CHECK(schema_violations(schema, written) == std::vector<std::string>{});
  std::stringstream again;
  write_result(result, again);
  CHECK(again.str() == read_text(query.path("r.json")));

  const Outcome drawn = provis_run({"draw", query.scene, query.path("r.json"), "--view-image",
                                    query.path("v.png"), "--above", query.path("a.png"), "--size", "120x80"});
  CHECK(drawn.status == 0);
  CHECK(std::filesystem::file_size(query.path("v.png")) > 0);
  CHECK(std::filesystem::file_size(query.path("a.png")) > 0);
}

TEST_CASE("segment: the lists of pixels are lines of JSON that fill the segment") {
  const SegmentRun query;
  REQUIRE(query.along({"--intervals", query.path("lists")}).status == 0);
  std::istringstream lines(read_text(query.path("lists")));
  std::string line;
  std::size_t count = 0;
  while (std::getline(lines, line)) {
    const Json pixel = Json::parse(line);
    CHECK(pixel["frame"] == count / 256);
    CHECK(pixel["row"] == count / 16 % 16);
    CHECK(pixel["column"] == count % 16);
    CHECK(pixel["sights"].front()[0] == "0/1");
    CHECK(pixel["sights"].back()[1] == "1/1");
    ++count;
  }
  CHECK(count == 6 * 256);
}

TEST_CASE("segment: a rectangle is its four sides, and runs add cubes that the seed turns") {
  const SegmentRun query;
  REQUIRE(query
              .run({"--rect", "0,0,0:0.01,0,0:0,0.02,0", "--runs", "2", "--seed", "5", "--out",
                    query.path("r.json")})
              .status == 0);
  const SegmentQuery q = read_result(query.path("r.json")).header.segments.value();
  REQUIRE(q.paths.size() == 4);
  CHECK(q.paths[1].from == Vec3d{0.01, 0, 0});
  CHECK(q.paths[2].from == Vec3d{0.01, 0.02, 0});
  CHECK(q.paths[3].to == q.paths[0].from);
  CHECK(q.frames.size() == 12);
  CHECK_FALSE(q.frames[0] == q.frames[6]);
  REQUIRE(query.along({"--runs", "1", "--seed", "6", "--out", query.path("s.json")}).status == 0);
  CHECK_FALSE(read_result(query.path("s.json")).header.segments->frames[0] == q.frames[0]);
}

TEST_CASE("segment: both engines, all certain policies and any number of threads write one result") {
  const SegmentRun query;
  Json first;
  for (const Words& how : {Words{}, Words{"--threads", "1"}, Words{"--engine", "plain"},
                           Words{"--memory", "1"}, Words{"--arithmetic", "exact"}}) {
    const Outcome outcome = query.along(how + Words{"--out", "-"});
    REQUIRE(outcome.status == 0);
    Json json = Json::parse(outcome.out);
    json.erase("stats");
    json["query"].erase("arithmetic");
    for (Json& s : json["seen"]) s.erase("length");
    if (first.is_null()) first = json;
    CHECK(json == first);
  }
}

TEST_CASE("segment: single viewpoints are told from the continuous answer") {
  const SegmentRun query;
  const Outcome outcome =
      query.along({"--method", "sampled", "--viewpoints", "7", "--out", query.path("r.json"), "--ids", "-"});
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out == "0\n2\n");
  const ResultFile result = read_result(query.path("r.json"));
  CHECK(result.set.guarantee == Guarantee::sampled);
  CHECK(result.boundary == std::vector<PrimitiveId>{0, 2});
  CHECK(result.seen.empty());
  CHECK(result.header.options.at("method") == "sampled");
  CHECK(result.header.options.at("viewpoints") == "7");
  const Json schema =
      Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
  CHECK(schema_violations(schema, Json::parse(read_text(query.path("r.json")))) ==
        std::vector<std::string>{});
  const Outcome drawn =
      provis_run({"draw", query.scene, query.path("r.json"), "--epi", query.path("e.png"), "--row", "3"});
  CHECK(drawn.status == 2);
  CHECK_THAT(drawn.err, Catch::Contains("single viewpoints"));
  const auto refused = [&](const Words& more, const char* option) {
    const Outcome no = query.along(more);
    CHECK(no.status == 1);
    CHECK_THAT(no.err, Catch::Contains(option));
  };
  refused({"--viewpoints", "7"}, "--viewpoints");
  refused({"--method", "sampled"}, "--viewpoints");
  for (const Words& more : {Words{"--witness"}, Words{"--intervals", "-"}, Words{"--rank", "-"},
                            Words{"--engine", "plain"}, Words{"--arithmetic", "exact"}})
    refused(Words{"--method", "sampled", "--viewpoints", "7"} + more, more.front().c_str());
  refused({"--method", "sampled", "--viewpoints", "0"}, "--viewpoints");
}

TEST_CASE("segment: doubles can be checked, and nothing else") {
  const SegmentRun query;
  const Outcome outcome = query.along({"--arithmetic", "doubles", "--check"});
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.out, Catch::Contains("wrong      0 of these signs\n"));
  for (const Words& more : {Words{}, Words{"--arithmetic", "doubles", "--engine", "plain"},
                            Words{"--arithmetic", "doubles", "--intervals", "-"}})
    CHECK_THAT(query.along(more + Words{"--check"}).err, Catch::Contains("--check"));
}

TEST_CASE("segment: what makes no sense is refused with the option's name") {
  const SegmentRun query;
  const auto complaint = [&](const Words& words) {
    const Outcome outcome = query.run(words);
    CHECK(outcome.status == 1);
    CHECK(outcome.out.empty());
    return outcome.err;
  };
  CHECK_THAT(complaint({}), Catch::Contains("--from"));
  CHECK_THAT(complaint({"--from", "0,0,0"}), Catch::Contains("--to"));
  CHECK_THAT(complaint({"--rect", "0,0,0:1,0,0"}), Catch::Contains("--rect"));
  CHECK_THAT(complaint({"--from", "0,0,0", "--to", "1,0"}), Catch::Contains("--to"));
  CHECK_THAT(complaint({"--from", "0,0,0", "--to", "1,0,0", "--seed", "3"}), Catch::Contains("--seed"));
  CHECK_THAT(complaint({"--from", "0,0,0", "--to", "1,0,0", "--faces", "6", "--dir", "0,0,-1"}),
             Catch::Contains("--faces"));
  CHECK_THAT(complaint({"--from", "0,0,0", "--to", "1,0,0", "--out", "-", "--ids", "-"}),
             Catch::Contains("standard output"));
  CHECK_THAT(complaint({"--from", "0,0,0", "--to", "1,0,0", "--arithmetic", "doubles", "--witness"}),
             Catch::Contains("witnesses"));
}

TEST_CASE("segment: spheres are beyond it") {
  const TempFolder directory;
  const std::string scene = write_particles(directory.path() / "p.ply");
  const Outcome outcome = provis_run({"segment", scene, "--from", "0,0,0", "--to", "1,0,0", "--size", "2x2"});
  CHECK(outcome.status == 3);
  CHECK_THAT(outcome.err, Catch::Contains("spheres"));
}
