// Files of public test suites that a loader must survive. Each is loaded by the program in a child that has
// little memory and time, and must come to what hostile.json expects: every triangle, or one line that says
// what is wrong.

#include <sys/wait.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/sanitized.hpp"

namespace provis::test {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::size_t children = 2;             ///< at a time
constexpr std::chrono::seconds time_limit{10};  ///< of one child

/// What loading a file must come to; hostile.json says what its members mean.
struct Expectation {
  int status = 0;
  std::uint64_t triangles = 0, spheres = 0;
  std::vector<std::string> places;  ///< the error must name one of them
  std::uint64_t memory = 0;         ///< bytes, or 0: as much as its size allows
};

/// A file that is being loaded.
struct Loading {
  std::string name;
  Child child;
  Clock::time_point deadline;
};

std::map<std::string, Expectation> read_expectations();
Expectation expectation_of(const std::string& name, const nlohmann::json& entry);
std::optional<fs::path> hostile_folder();
std::set<std::string> scene_files(const fs::path& folder);
bool is_scene(const fs::path& file);
std::uint64_t bytes_behind(const fs::path& file);
Loading start(const fs::path& folder, const std::string& name, const Expectation& expected);
bool has_ended(const Loading& loading);
std::string problem_of(const fs::path& file, const Expectation& expected, const Outcome& outcome);
std::string problem_of_counts(const Expectation& expected, const std::string& out);
std::string problem_of_message(const fs::path& file, const Expectation& expected, std::string message);

std::map<std::string, Expectation> read_expectations() {
  const auto json =
      nlohmann::json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/tests/scene/hostile.json"));
  std::map<std::string, Expectation> all;
  for (const auto& [name, entry] : json.items()) {
    if (name != "_about") all[name] = expectation_of(name, entry);
  }
  return all;
}

Expectation expectation_of(const std::string& name, const nlohmann::json& entry) {
  Expectation expected;
  expected.status = entry.at("exit");
  expected.memory = entry.value("memory", std::uint64_t{0});
  bool sound = expected.status == 0 || expected.status == 2 || expected.status == 3;
  sound = sound && !entry.at("why").get<std::string>().empty();
  if (expected.status == 0) {
    expected.triangles = entry.at("triangles");
    expected.spheres = entry.value("spheres", std::uint64_t{0});
    sound = sound && !entry.contains("place");
  } else {
    const nlohmann::json& place = entry.at("place");
    for (const auto& text : place.is_array() ? place : nlohmann::json::array({place})) {
      expected.places.push_back(text);
      sound = sound && !expected.places.back().empty();
    }
    sound = sound && !expected.places.empty() && !entry.contains("triangles");
  }
  if (!sound) throw std::runtime_error("hostile.json: " + name + " is no expectation");
  return expected;
}

/// Where the files are; where they are not, the reason is printed, or is a failure, as with scenes.
std::optional<fs::path> hostile_folder() {
  const fs::path folder = shared_scenes_folder().parent_path() / "invalid";
  if (fs::is_directory(folder)) return fs::canonical(folder);
  const char* required = std::getenv("PROVIS_REQUIRE_SCENES");
  if (required != nullptr && std::string(required) == "1")
    throw std::runtime_error("required folder is missing: " + folder.string());
  static int skipped = 0;
  std::cout << "skipped (" << ++skipped << " so far), no such folder: " << folder.string() << '\n';
  return std::nullopt;
}

/// Their paths below the folder.
std::set<std::string> scene_files(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file() && is_scene(entry.path()))
      names.insert(entry.path().lexically_relative(folder).generic_string());
  }
  return names;
}

bool is_scene(const fs::path& file) {
  const fs::path extension = file.extension();
  return extension == ".gltf" || extension == ".glb" || extension == ".ply";
}

/// The size of a file and of those beside it that it names.
std::uint64_t bytes_behind(const fs::path& file) {
  const std::string content = read_text(file);
  std::uint64_t bytes = content.size();
  for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path())) {
    if (entry.is_regular_file() && !is_scene(entry.path()) &&
        content.find(entry.path().filename().string()) != std::string::npos)
      bytes += entry.file_size();
  }
  return bytes;
}

Loading start(const fs::path& folder, const std::string& name, const Expectation& expected) {
  const fs::path file = folder / name;
  const std::uint64_t own = (std::uint64_t{1} << 30) + 16 * bytes_behind(file);
  const std::uint64_t memory = expected.memory != 0 ? expected.memory : own;
  const std::string shell = !PROVIS_SANITIZED ? "ulimit -v " + std::to_string(memory / 1024) : "";
  return {name, Child({"info", "--json", file.string()}, shell), Clock::now() + time_limit};
}

/// Leaves the child to be waited for.
bool has_ended(const Loading& loading) {
  siginfo_t info{};
  const int flags = WEXITED | WNOHANG | WNOWAIT;
  if (waitid(P_PID, static_cast<id_t>(loading.child.pid()), &info, flags) != 0)
    throw std::runtime_error("a child was lost: " + loading.name);
  return info.si_pid != 0;
}

/// Empty where the outcome is the expected one.
std::string problem_of(const fs::path& file, const Expectation& expected, const Outcome& outcome) {
  if (outcome.status > 128)
    return "ended by signal " + std::to_string(outcome.status - 128) + "\n" + outcome.err;
  if (outcome.status != expected.status) {
    return "exit status " + std::to_string(outcome.status) + " instead of " +
           std::to_string(expected.status) + "\n" + (outcome.err.empty() ? outcome.out : outcome.err);
  }
  if (expected.status == 0) return problem_of_counts(expected, outcome.out);
  if (!outcome.out.empty()) return "a result beside the error\n" + outcome.out;
  return problem_of_message(file, expected, outcome.err);
}

std::string problem_of_counts(const Expectation& expected, const std::string& out) {
  const auto json = nlohmann::json::parse(out, nullptr, false);
  if (json.is_discarded() || !json.contains("scene")) return "no JSON\n" + out;
  const auto differs = [&](const char* what, std::uint64_t count) {
    return json["scene"].value(what, nlohmann::json()) != count;
  };
  if (differs("triangles", expected.triangles) || differs("spheres", expected.spheres)) {
    return "instead of " + std::to_string(expected.triangles) + " triangles and " +
           std::to_string(expected.spheres) + " spheres\n" + json["scene"].dump();
  }
  return {};
}

std::string problem_of_message(const fs::path& file, const Expectation& expected, std::string message) {
  const std::string said = "\n" + message, path = file.string(), name = file.filename().string();
  if (message.empty() || message.find('\n') != message.size() - 1) return "the error is not one line" + said;
  if (message.find(name) == std::string::npos) return "the error does not name the file" + said;
  // A path may hold the words that are looked for.
  for (const std::string& part : {path, name}) {
    for (std::size_t at; (at = message.find(part)) != std::string::npos;) message.erase(at, part.size());
  }
  const auto named = [&](const std::string& place) { return message.find(place) != std::string::npos; };
  if (std::none_of(expected.places.begin(), expected.places.end(), named))
    return "the error does not name " + expected.places.front() + said;
  return {};
}

TEST_CASE("each hostile file has an expectation, and each expectation its file") {
  const auto expectations = read_expectations();
  CHECK(expectations.size() > 600);
  const auto folder = hostile_folder();
  if (!folder) return;
  const std::set<std::string> files = scene_files(*folder);
  for (const std::string& name : files) {
    if (expectations.count(name) == 0) FAIL_CHECK("not in hostile.json: " << name);
  }
  for (const auto& [name, expected] : expectations) {
    if (files.count(name) == 0) FAIL_CHECK("no such file: " << name);
  }
}

TEST_CASE("hostile files load in full or end in one clear line") {
  const auto folder = hostile_folder();
  if (!folder) return;
  const auto expectations = read_expectations();
  std::vector<Loading> running;
  std::size_t ended = 0;
  const auto judge = [&](Loading& loading) {
    const bool in_time = has_ended(loading);
    if (!in_time) kill(loading.child.pid(), SIGKILL);
    const Outcome outcome = loading.child.wait();
    const fs::path file = *folder / loading.name;
    const std::string problem =
        in_time ? problem_of(file, expectations.at(loading.name), outcome) : "is not done in time";
    if (!problem.empty()) FAIL_CHECK(loading.name << ": " << problem);
    ++ended;
  };
  const auto judge_all_but = [&](std::size_t count) {
    while (running.size() > count) {
      const auto done = std::find_if(running.begin(), running.end(), [](const Loading& loading) {
        return Clock::now() > loading.deadline || has_ended(loading);
      });
      if (done == running.end()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        continue;
      }
      judge(*done);
      running.erase(done);
    }
  };
  for (const auto& [name, expected] : expectations) {
    if (!fs::exists(*folder / name)) continue;  // which the other test case reports
    judge_all_but(children - 1);
    running.push_back(start(*folder, name, expected));
  }
  judge_all_but(0);
  CHECK(ended > 600);
}

TEST_CASE("an outcome other than the expected one is noticed") {
  const fs::path file = "scenes/byte.ply";
  const Expectation loads{0, 3, 0, {}, 0}, fails{2, 0, 0, {"line 4", "byte"}, 0};
  const auto problem = [&](const Expectation& expected, const Outcome& outcome) {
    return problem_of(file, expected, outcome);
  };
  const std::string counts = R"({"scene": {"triangles": 3, "spheres": 0}})";
  CHECK(problem(loads, {0, counts, ""}).empty());
  CHECK(!problem(loads, {0, R"({"scene": {"triangles": 2, "spheres": 0}})", ""}).empty());
  CHECK(!problem(loads, {0, R"({"scene": {"triangles": 3, "spheres": 1}})", ""}).empty());
  CHECK(!problem(loads, {0, R"({"scene": {"triangles": 3}})", ""}).empty());
  CHECK(!problem(loads, {0, "3 triangles", ""}).empty());
  CHECK(!problem(loads, {2, "", "error: scenes/byte.ply: line 4\n"}).empty());
  CHECK(!problem(loads, {139, counts, ""}).empty());
  CHECK(problem(fails, {2, "", "error: scenes/byte.ply: line 4: odd\n"}).empty());
  CHECK(problem(fails, {2, "", "error: byte.ply: byte 7: odd\n"}).empty());
  CHECK(!problem(fails, {3, "", "error: scenes/byte.ply: line 4: odd\n"}).empty());
  CHECK(!problem(fails, {2, "", "error: scenes/byte.ply: odd\n"}).empty());
  CHECK(!problem(fails, {2, "", "error: line 4: odd\n"}).empty());
  CHECK(!problem(fails, {2, "", "error: scenes/byte.ply: line 4\nodd\n"}).empty());
  CHECK(!problem(fails, {2, "", "error: scenes/byte.ply: line 4"}).empty());
  CHECK(!problem(fails, {2, counts, "error: scenes/byte.ply: line 4: odd\n"}).empty());
  CHECK(!problem(fails, {2, "", ""}).empty());
}

}  // namespace
}  // namespace provis::test
