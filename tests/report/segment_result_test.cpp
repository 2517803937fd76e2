// Results along segments: every member reads back, obeys the schema, and is not taken on trust.

#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "provis/error.hpp"
#include "tests/report/example_result.hpp"
#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using Json = nlohmann::json;

namespace {

ResultFile segment_result() {
  ResultFile result = example_result();
  result.set.answers = "R10";
  result.set.guarantee = Guarantee::exact;
  result.set.subdivision.clear();
  result.set.status[3] = Status::hidden;
  SegmentQuery query;
  query.paths = {{{0.1, 0, 1.0 / 3}, {1, 2, 3}}, {{1, 2, 3}, {1, 2, 3}}};
  query.frames = omni({0, 0, 0}).frames;
  query.pixels = {3, 16384};
  result.header.segments = query;
  result.header.view = query.first_view();
  result.boundary = {0, 5};
  result.seen = {{0, 1, 1e-17}, {2, 123456789012, 0.1}, {5, 2, 2}};
  return result;
}

std::string written(const ResultFile& result) {
  std::ostringstream text;
  write_result(result, text);
  return text.str();
}

/// What reading the result says after a change to its JSON; empty where it was read.
std::string complaint(const Json& json) {
  const TempFolder folder;
  const std::filesystem::path file = folder.path() / "r.json";
  std::ofstream(file) << json.dump();
  try {
    read_result(file);
  } catch (const Error& e) {
    CHECK(e.code() == Error::Code::invalid_input);
    return e.what();
  }
  return "";
}

}  // namespace

TEST_CASE("a result along segments reads back and is written again as it was") {
  const TempFolder folder;
  const ResultFile result = segment_result();
  write_result(result, folder.path() / "r.json");
  const ResultFile back = read_result(folder.path() / "r.json");
  CHECK(written(back) == written(result));
  REQUIRE(back.header.segments);
  CHECK(back.header.segments->paths[0].from == Vec3d{0.1, 0, 1.0 / 3});
  CHECK(back.header.segments->frames == result.header.segments->frames);
  CHECK(back.header.view.projection == Projection::omni);
  CHECK(back.boundary == result.boundary);
  REQUIRE(back.seen.size() == 3);
  CHECK(back.seen[1].pixels == 123456789012);
  CHECK(back.seen[0].length == 1e-17);
}

TEST_CASE("a result along segments obeys the schema, a damaged one does not") {
  const Json schema =
      Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
  const Json good = Json::parse(written(segment_result()));
  CHECK(schema_violations(schema, good) == std::vector<std::string>{});
  for (const auto& [pointer, value] :
       std::vector<std::pair<const char*, Json>>{{"/query/pixels", {1}},
                                                 {"/query/segments/0/from", {1, 2}},
                                                 {"/boundary", {-1}},
                                                 {"/seen/0/pixels", "many"}}) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    INFO(pointer);
    CHECK_FALSE(schema_violations(schema, bad).empty());
  }
}

TEST_CASE("the reader names what is wrong with a result along segments") {
  const Json good = Json::parse(written(segment_result()));
  CHECK(complaint(good).empty());
  const auto after = [&](const char* pointer, const Json& value) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    return complaint(bad);
  };
  CHECK_THAT(after("/boundary", {1}), Catch::Contains("boundary"));
  CHECK_THAT(after("/boundary", {5, 0}), Catch::Contains("boundary"));
  CHECK_THAT(after("/seen/1/id", 3), Catch::Contains("seen"));
  CHECK_THAT(after("/query/segments", Json::array()), Catch::Contains("segments"));
  CHECK_THAT(after("/query/pixels", {0, 5}), Catch::Contains("size"));
  CHECK_THAT(after("/query/frames", Json::array()), Catch::Contains("frame"));
  CHECK_THAT(after("/query/kind", "line"), Catch::Contains("kind"));
}
