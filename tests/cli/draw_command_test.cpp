// draw: pictures of a result, and the results it refuses.

#include <catch2/catch.hpp>

#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;

namespace {

struct Drawn {
  explicit Drawn(const std::vector<std::string>& more) {
    std::vector<std::string> words = {"point", scene, "--eye", "0,0,0", "--out", result};
    words.insert(words.end(), more.begin(), more.end());
    REQUIRE(provis_run(words).status == 0);
  }

  TempFolder directory;
  std::string scene = write_small_scene(directory.path() / "s.ply");
  std::string result = (directory.path() / "r.json").string();
  std::string view = (directory.path() / "view.png").string(),
              above = (directory.path() / "above.png").string();
};

// Width and height as the PNG's header has them.
std::pair<int, int> png_size(const std::string& file) {
  const std::string bytes = read_text(file);
  REQUIRE(bytes.size() > 24);
  REQUIRE(bytes.substr(1, 3) == "PNG");
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t i = at; i < at + 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[i]);
    return value;
  };
  return {number(16), number(20)};
}

}  // namespace

TEST_CASE("both pictures, in the window's proportions or as asked") {
  const Drawn drawn({"--dir", "0,0,-1", "--size", "100x100"});
  REQUIRE(provis_run({"draw", drawn.scene, drawn.result, "--view-image", drawn.view, "--above", drawn.above})
              .status == 0);
  CHECK(png_size(drawn.view) == std::pair(1280, 1280));
  CHECK(png_size(drawn.above) == std::pair(1280, 720));
  REQUIRE(
      provis_run({"draw", drawn.scene, drawn.result, "--view-image", drawn.view, "--size", "64x48"}).status ==
      0);
  CHECK(png_size(drawn.view) == std::pair(64, 48));
}

TEST_CASE("omni results and perturbed results are drawn from the scene they were computed on") {
  const Drawn omni({"--view", "omni"});
  CHECK(provis_run({"draw", omni.scene, omni.result, "--view-image", omni.view, "--above", omni.above})
            .status == 0);
  CHECK(png_size(omni.view) == std::pair(1280, 853));
  const Drawn moved(
      {"--dir", "0,0,-1", "--perturb", "1e-8", "--seed", "9", "--sides", "both", "--opacity", "all"});
  CHECK(provis_run({"draw", moved.scene, moved.result, "--above", moved.above}).status == 0);
}

TEST_CASE("a scene is loaded again as the result recorded it") {
  Drawn drawn({"--dir", "0,0,-1"});
  const std::string broken = write_broken_scene(drawn.directory.path() / "broken.ply");
  const std::string result = (drawn.directory.path() / "broken.json").string();
  REQUIRE(
      provis_run({"point", broken, "--eye", "0,0,0", "--dir", "0,0,-1", "--skip-invalid", "--out", result})
          .status == 0);
  CHECK(provis_run({"draw", broken, result, "--above", drawn.above}).status == 0);
}

TEST_CASE("a result of another scene is refused") {
  const Drawn drawn({"--dir", "0,0,-1"});
  std::string text = read_text(drawn.scene);
  text.replace(text.find("0.5 -1 -2"), 3, "0.6");
  std::ofstream(drawn.scene) << text;
  const Outcome outcome = provis_run({"draw", drawn.scene, drawn.result, "--above", drawn.above});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.err, Catch::Contains("another scene"));
  CHECK_FALSE(std::filesystem::exists(drawn.above));
}

TEST_CASE("a picture that cannot be written ends with 4") {
  const Drawn drawn({"--dir", "0,0,-1"});
  const Outcome outcome = provis_run(
      {"draw", drawn.scene, drawn.result, "--above", (drawn.directory.path() / "no/a.png").string()});
  CHECK(outcome.status == 4);
  CHECK_THAT(outcome.err, Catch::Contains("no/a.png"));
}
