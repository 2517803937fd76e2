// How the program ends: help, and one case for each kind of failure.

#include <catch2/catch.hpp>

#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"
#include "tests/support/sanitized.hpp"

using namespace provis;
using namespace provis::test;

namespace {

void fails(const Outcome& outcome, int status, const std::string& what) {
  CHECK(outcome.status == status);
  CHECK(outcome.out.empty());
  CHECK_THAT(outcome.err, Catch::StartsWith("provis: error: "));
  CHECK_THAT(outcome.err, Catch::Contains(what));
}

}  // namespace

TEST_CASE("help and version go to standard output") {
  const Outcome help = provis_run({"--help"});
  CHECK(help.status == 0);
  CHECK(help.err.empty());
  for (const char* word : {"info", "export", "point", "draw", "provis point house.glb"}) {
    CHECK_THAT(help.out, Catch::Contains(word));
  }
  for (const char* command : {"info", "export", "point", "draw"}) {
    const Outcome own = provis_run({command, "--help"});
    CHECK(own.status == 0);
    CHECK_THAT(own.out, Catch::Contains("Example"));
  }
  const Outcome point = provis_run({"point", "--help"});
  for (const char* text : {"[0,1,0;", "[60]", "degrees", "[1280x720", "scene units", "{material,both}"}) {
    CHECK_THAT(point.out, Catch::Contains(text));
  }
  for (const char* option : {"--scene", "--time", "--animation", "--radius", "--skip-invalid", "seconds"}) {
    CHECK_THAT(point.out, Catch::Contains(option));
  }
  const Outcome version = provis_run({"--version"});
  CHECK(version.status == 0);
  CHECK_THAT(version.out, Catch::StartsWith("provis "));
}

TEST_CASE("help fits 100 columns") {
  for (const char* command : {"", "info", "export", "point", "draw"}) {
    std::vector<std::string> words = {command, "--help"};
    if (words[0].empty()) words.erase(words.begin());
    std::istringstream help(provis_run(words).out);
    for (std::string line; std::getline(help, line);) {
      CAPTURE(line);
      CHECK(line.size() <= 100);
    }
  }
}

TEST_CASE("wrong usage ends with 1") {
  const TempFolder directory;
  const std::string scene = write_small_scene(directory.path() / "s.ply");
  fails(provis_run({}), 1, "no command");
  fails(provis_run({"paint"}), 1, "paint");
  fails(provis_run({"--colour"}), 1, "--colour");
  fails(provis_run({"info"}), 1, "SCENE");
  fails(provis_run({"info", scene, "--sides", "front"}), 1, "--sides");
  fails(provis_run({"export", scene}), 1, "--out");
  fails(provis_run({"point", scene, "--dir", "1,0,0"}), 1, "--eye");
  fails(provis_run({"point", scene, "--eye", "0,0,0"}), 1, "no direction is given");
  fails(provis_run({"point", scene, "--eye", "0,0,nan", "--dir", "1,0,0"}), 1, "--eye");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "1,0,0", "--method", "guess"}), 1, "--method");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "1,0,0", "--threads", "-1"}), 1, "--threads");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "1,0,0", "--seed", "1"}), 1, "--seed");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "1,0,0", "--perturb", "0"}), 1, "--perturb");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "1,0,0", "--out", "-", "--ids", "-"}), 1,
        "--ids");
  fails(provis_run({"point", scene, "--views", "v.json:a", "--eye", "0,0,0"}), 1, "--eye");
  fails(provis_run({"point", scene, "--views", "v.json"}), 1, "FILE:NAME");
  fails(provis_run({"draw", scene, "r.json"}), 1, "--above");
}

TEST_CASE("input that is unreadable or invalid ends with 2") {
  const TempFolder directory;
  const std::string garbage = (directory.path() / "garbage.ply").string();
  std::ofstream(garbage) << "ply\nformat ascii 1.0\nelement vertex three\nend_header\n";
  const std::string missing = (directory.path() / "missing.glb").string();
  fails(provis_run({"info", missing}), 2, "missing.glb");
  fails(provis_run({"info", garbage}), 2, "garbage.ply");
  fails(provis_run({"point", garbage, "--eye", "0,0,0", "--dir", "1,0,0"}), 2, "garbage.ply");
  fails(provis_run({"export", missing, "--out", (directory.path() / "x.ply").string()}), 2, "missing.glb");
  const std::string scene = write_small_scene(directory.path() / "s.ply");
  fails(provis_run({"draw", scene, missing, "--above", (directory.path() / "a.png").string()}), 2,
        "missing.glb");
  fails(provis_run({"point", scene, "--views", missing + ":v"}), 2, "missing.glb");
  CHECK_FALSE(std::filesystem::exists(directory.path() / "x.ply"));
}

TEST_CASE("an output that cannot be written ends with 4 and leaves nothing") {
  const TempFolder directory;
  const std::string scene = write_small_scene(directory.path() / "s.ply");
  const std::string nowhere = (directory.path() / "no/such/file").string();
  fails(provis_run({"export", scene, "--out", nowhere}), 4, "no/such/file");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "0,0,-1", "--out", nowhere}), 4,
        "no/such/file");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "0,0,-1", "--ids", nowhere}), 4,
        "no/such/file");
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "0,0,-1"}, "exec >/dev/full"), 4,
        "standard output");
  fails(provis_run({"info", scene}, "exec >/dev/full"), 4, "standard output");
  // The first output is good, the second is not: neither appears.
  const std::string good = (directory.path() / "good.json").string();
  fails(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "0,0,-1", "--out", good, "--ids", nowhere}), 4,
        "such");
  CHECK(std::distance(std::filesystem::directory_iterator(directory.path()), {}) == 1);
}

#if !PROVIS_SANITIZED
TEST_CASE("too little memory ends with 3 and says what it was for") {
  const TempFolder directory;
  const std::string scene = write_small_scene(directory.path() / "s.ply"),
                    result = (directory.path() / "r.json").string();
  REQUIRE(provis_run({"point", scene, "--eye", "0,0,0", "--dir", "0,0,-1", "--out", result}).status == 0);
  const std::string picture = (directory.path() / "p.png").string();
  fails(provis_run({"draw", scene, result, "--above", picture, "--size", "16384x16384"}, "ulimit -v 600000"),
        3, "out of memory while drawing");
  CHECK_FALSE(std::filesystem::exists(picture));
}
#endif
