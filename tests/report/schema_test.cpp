// Written results obey the published schema, and the schema rejects what is not one.

#include "tests/report/schema.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "tests/report/example_result.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using Json = nlohmann::json;

namespace {

Json schema() {
  return Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/visible-set.schema.json"));
}

Json written(const ResultFile& result) {
  std::stringstream text;
  write_result(result, text);
  return Json::parse(text.str());
}

}  // namespace

TEST_CASE("a result with every member is valid") {
  CHECK(schema_violations(schema(), written(example_result())) == std::vector<std::string>{});
}

TEST_CASE("an omnidirectional result is valid") {
  ResultFile result = example_result();
  result.header.view.projection = Projection::omni;
  result.header.view.frames.assign(6, Frame{});
  CHECK(schema_violations(schema(), written(result)) == std::vector<std::string>{});
}

TEST_CASE("a result without anything optional is valid") {
  ResultFile result = example_result();
  result.set.witnesses.clear();
  result.set.subdivision.clear();
  result.header.left_out.clear();
  const Json json = written(result);
  CHECK_FALSE(json["scene"].contains("left_out"));
  CHECK_FALSE(json.contains("witnesses"));
  CHECK_FALSE(json.contains("subdivision"));
  CHECK(schema_violations(schema(), json) == std::vector<std::string>{});
}

TEST_CASE("the schema notices every kind of damage") {
  const Json good = written(example_result());
  const auto damaged = [&](const char* pointer, const Json& value) {
    Json bad = good;
    bad[Json::json_pointer(pointer)] = value;
    return !schema_violations(schema(), bad).empty();
  };
  CHECK(damaged("/format", "provis.scene-info"));
  CHECK(damaged("/version", 2));
  CHECK(damaged("/scene/hash", "abc"));
  CHECK(damaged("/query/eye", Json::array({1, 2})));
  CHECK(damaged("/query/sides", 1));
  CHECK(damaged("/query/projection", "fisheye"));
  CHECK(damaged("/visible", Json::array({-1})));
  CHECK(damaged("/witnesses/0/origin/0/0", 17));
  CHECK(damaged("/guarantee", "certain"));
  CHECK(damaged("/surplus", 1));
  CHECK(damaged("/scene/left_out/0/reason", 1));
  CHECK(damaged("/scene/left_out/0/surplus", "x"));
  CHECK(damaged("/stats/signs/facing/filter", "many"));
  const Json rules = schema();
  REQUIRE(rules["required"].size() == 12);
  for (const Json& key : rules["required"]) {
    Json bad = good;
    bad.erase(key.get<std::string>());
    CHECK_FALSE(schema_violations(rules, bad).empty());
  }
}
