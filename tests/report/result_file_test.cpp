// What is written reads back bit for bit, and runs differ in "stats" only.

#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "provis/error.hpp"
#include "tests/report/example_result.hpp"
#include "tests/scene/files.hpp"

using namespace provis;

namespace {

std::string text_of(const ResultFile& result) {
  std::stringstream text;
  write_result(result, text);
  return text.str();
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool same_bits(const Vec3d& a, const Vec3d& b) {
  return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

}  // namespace

TEST_CASE("a result survives writing and reading") {
  const TempFolder directory;
  const ResultFile result = example_result();
  write_result(result, directory.path() / "r.json");
  const ResultFile back = read_result(directory.path() / "r.json");

  CHECK(back.header.scene_file == result.header.scene_file);
  CHECK(back.header.scene_hash == result.header.scene_hash);
  CHECK(back.header.triangles == 5);
  CHECK(back.header.spheres == 1);
  CHECK(back.header.options == result.header.options);
  REQUIRE(back.header.left_out.size() == 2);
  CHECK(back.header.left_out[0].place == "line 12");
  CHECK(back.header.left_out[1].reason == "a \n reason");
  CHECK(back.header.view.projection == Projection::pinhole);
  CHECK(same_bits(back.header.view.eye, result.header.view.eye));
  REQUIRE(back.header.view.frames.size() == 1);
  const Frame &a = back.header.view.frames[0], &b = result.header.view.frames[0];
  CHECK(same_bits(a.right, b.right));
  CHECK(same_bits(a.up, b.up));
  CHECK(same_bits(a.forward, b.forward));
  CHECK(a.window == b.window);

  CHECK(back.set.status == result.set.status);
  CHECK(back.set.guarantee == Guarantee::bounds);
  CHECK(back.set.answers == "R7");
  CHECK(back.set.eye_on_primitive);
  REQUIRE(back.set.witnesses.size() == 1);
  CHECK(back.set.witnesses[0].primitive == 2);
  CHECK(back.set.witnesses[0].origin.x.mantissa == "-123456789012345678901234567890");
  CHECK(back.set.witnesses[0].origin.x.exponent == -70);
  REQUIRE(back.set.subdivision.size() == 2);
  CHECK(back.set.subdivision[0].corners.size() == 3);
  CHECK(back.set.subdivision[0].visible == std::vector<PrimitiveId>{0, 2});
  CHECK(back.set.subdivision[1].area == "1/2");
  CHECK(back.set.stats.signs.at(Predicate::turn, Tier::exact) == 123456789012345ULL);
  CHECK(back.set.stats.sampling.locations == 10);
  CHECK(back.set.stats.iteration.visible_after_first == 36);
  CHECK(back.set.stats.peak_bytes == 14);
  CHECK(back.set.stats.checked);
  CHECK(back.set.stats.signs.wrong_of(Predicate::nearer) == 15);
  CHECK(text_of(back) == text_of(result));
}

TEST_CASE("six frames survive writing and reading") {
  const TempFolder directory;
  ResultFile result = example_result();
  result.header.view = omni({1, 2, 3});
  write_result(result, directory.path() / "r.json");
  const ResultFile back = read_result(directory.path() / "r.json");
  CHECK(back.header.view.projection == Projection::omni);
  CHECK(back.header.view.frames == result.header.view.frames);
}

TEST_CASE("the costs of a run change nothing but stats") {
  ResultFile other = example_result();
  other.set.stats = {};
  other.set.stats.threads = 7;
  auto a = nlohmann::json::parse(text_of(example_result())), b = nlohmann::json::parse(text_of(other));
  CHECK(a != b);
  a.erase("stats");
  b.erase("stats");
  CHECK(a == b);
}

TEST_CASE("a million ids take few lines and read back") {
  const TempFolder directory;
  ResultFile result = example_result();
  result.header.triangles = 1000000;
  result.header.spheres = 0;
  result.set.status.assign(1000000, Status::visible);
  result.set.status[31] = Status::hidden;
  result.set.witnesses.clear();
  result.set.subdivision.clear();
  write_result(result, directory.path() / "r.json");
  const std::string text = read_text(directory.path() / "r.json");
  CHECK(std::count(text.begin(), text.end(), '\n') < 60000);
  CHECK(read_result(directory.path() / "r.json").set.status == result.set.status);
}

TEST_CASE("a file name that is no UTF-8 is written all the same") {
  ResultFile result = example_result();
  result.header.scene_file = "caf\xe9.glb";
  CHECK(nlohmann::json::parse(text_of(result))["scene"]["file"] == "caf\xef\xbf\xbd.glb");
}

TEST_CASE("ids are the visible ones, ascending, one per line") {
  const TempFolder directory;
  write_ids(example_result().set, directory.path() / "ids");
  CHECK(read_text(directory.path() / "ids") == "0\n2\n5\n");
}

TEST_CASE("an output that cannot be written is an output error and leaves nothing behind") {
  const TempFolder directory;
  const auto code = [](auto write) {
    try {
      write();
    } catch (const Error& error) {
      return error.code();
    }
    return Error::Code::internal;
  };
  CHECK(code([&] { write_result(example_result(), directory.path() / "no/such/dir.json"); }) ==
        Error::Code::output);
  CHECK(code([&] { write_ids(example_result().set, directory.path() / "no/ids"); }) == Error::Code::output);
  CHECK(std::filesystem::is_empty(directory.path()));
}

TEST_CASE("what JSON cannot say is never written") {
  const TempFolder directory;
  ResultFile result = example_result();
  result.header.view.eye.x = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(write_result(result, directory.path() / "r.json"), Error);
  CHECK(std::filesystem::is_empty(directory.path()));
}
