// Files that are not results: each is refused, and the message names the place.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "provis/error.hpp"
#include "tests/report/example_result.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using Json = nlohmann::json;

namespace {

// The failure of reading this text: its code and message.
std::pair<Error::Code, std::string> failure(const std::string& text) {
  const TempFolder directory;
  std::ofstream(directory.path() / "r.json") << text;
  try {
    read_result(directory.path() / "r.json");
  } catch (const Error& error) {
    return {error.code(), error.what()};
  }
  return {Error::Code::internal, "was read"};
}

std::pair<Error::Code, std::string> failure_with(const char* pointer, const Json& value) {
  std::stringstream text;
  write_result(example_result(), text);
  Json json = Json::parse(text.str());
  json[Json::json_pointer(pointer)] = value;
  return failure(json.dump());
}

void refused(const std::pair<Error::Code, std::string>& failure, const std::string& place) {
  CHECK(failure.first == Error::Code::invalid_input);
  CHECK_THAT(failure.second, Catch::Contains(place));
}

}  // namespace

TEST_CASE("text that is no JSON") {
  refused(failure(""), "r.json");
  refused(failure("{\"format\": "), "byte 12");
  refused(failure("{\"a\": 1e999}"), "r.json");
  refused(failure("[1, 2]"), "is not an object");
}

TEST_CASE("a missing file") {
  try {
    read_result("no-such-file.json");
    FAIL("was read");
  } catch (const Error& error) {
    CHECK(error.code() == Error::Code::invalid_input);
    CHECK_THAT(error.what(), Catch::Contains("no-such-file.json"));
  }
}

TEST_CASE("members that are wrong are named") {
  refused(failure_with("/format", "something"), "format");
  refused(failure_with("/query/window/2", "x"), "query.window[2]");
  refused(failure_with("/query/eye", Json::array({1, 2})), "query.eye");
  refused(failure_with("/query/projection", "fisheye"), "query.projection");
  refused(failure_with("/query/perturb", 3), "query.perturb");
  refused(failure_with("/query/right", Json::array({0, 0, -1})), "query");
  refused(failure_with("/scene/triangles", 1e10), "scene.triangles");
  refused(failure_with("/scene/triangles", 4294967296), "scene");
  refused(failure_with("/scene/left_out", "none"), "scene.left_out");
  refused(failure_with("/scene/left_out/1/place", 5), "scene.left_out[1].place");
  refused(failure_with("/visible", Json::array({0, 2, 6})), "visible");
  refused(failure_with("/visible", Json::array({2, 0, 5})), "visible");
  refused(failure_with("/visible", Json::array({0, 3, 5})), "id 3");
  refused(failure_with("/counts/hidden", 3), "counts.hidden");
  refused(failure_with("/guarantee", "certain"), "guarantee");
  refused(failure_with("/eye_on_primitive", 1), "eye_on_primitive");
  refused(failure_with("/witnesses/0/direction/1/0", "5.5"), "witnesses[0].direction[1][0]");
  refused(failure_with("/subdivision/0/frame", 1), "subdivision[0].frame");
  refused(failure_with("/stats/signs/facing/mpfr", -1), "stats.signs.facing.mpfr");
}

TEST_CASE("a short file that claims billions of hidden primitives takes no memory for them") {
  const auto failed = failure_with("/scene/triangles", 2147483652);
  CHECK(failed.first == Error::Code::unsupported);
  CHECK_THAT(failed.second, Catch::Contains("primitives; this program reads results of up to 536870912"));
}

TEST_CASE("another version is unsupported, not invalid") {
  CHECK(failure_with("/version", 2).first == Error::Code::unsupported);
}
