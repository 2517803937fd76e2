// draw: pictures of a result, and the results it refuses.

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "provis/draw.hpp"
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

namespace {

struct DrawnPath : TempFolder {
  std::string scene = write_small_scene(path() / "s.ply");
  std::string result = (path() / "r.json").string(), lists = (path() / "lists").string();
  std::string epi = (path() / "epi.png").string(), expected = (path() / "expected.png").string();
  Words along = {"segment", scene, "--size", "32x24", "--from", "-0.75,0.1,0.5", "--to", "0.5,0,-0.5"};

  Outcome draw(const Words& more) const { return provis_run(Words{"draw", scene, result} + more); }
};

std::vector<PixelSights> row_of(const std::string& lists, int frame, int row) {
  std::vector<PixelSights> pixels;
  std::istringstream lines(read_text(lists));
  for (std::string line; std::getline(lines, line);) {
    const nlohmann::json pixel = nlohmann::json::parse(line);
    if (pixel["frame"] != frame || pixel["row"] != row) continue;
    pixels.emplace_back();
    for (const nlohmann::json& s : pixel["sights"]) pixels.back().sights.push_back({s[0], s[1], s[2]});
  }
  return pixels;
}

}  // namespace

TEST_CASE("draw: a row over time is what the pixels' lists say") {
  const DrawnPath drawn;
  REQUIRE(provis_run(drawn.along + Words{"--out", drawn.result, "--intervals", drawn.lists}).status == 0);
  REQUIRE(drawn.draw({"--epi", drawn.epi, "--row", "13", "--face", "5"}).status == 0);
  CHECK(png_size(drawn.epi) == std::pair(32, 720));
  const std::vector<PixelSights> pixels = row_of(drawn.lists, 5, 13);
  REQUIRE(
      std::any_of(pixels.begin(), pixels.end(), [](const PixelSights& p) { return p.sights.size() > 1; }));
  write_png(draw_over_time(pixels, 32, 720), drawn.expected);
  CHECK(read_text(drawn.epi) == read_text(drawn.expected));
  REQUIRE(drawn.draw({"--epi", drawn.epi, "--row", "13", "--face", "5", "--size", "50x40"}).status == 0);
  CHECK(png_size(drawn.epi) == std::pair(50, 40));
}

TEST_CASE("draw: a row over time refuses what it cannot show") {
  const DrawnPath drawn;
  REQUIRE(provis_run(drawn.along + Words{"--out", drawn.result}).status == 0);
  const auto refused = [&](const Words& words, int status, const char* what) {
    const Outcome outcome = drawn.draw(words);
    CHECK(outcome.status == status);
    CHECK_THAT(outcome.err, Catch::Contains(what));
    CHECK_FALSE(std::filesystem::exists(drawn.epi));
  };
  refused({"--epi", drawn.epi}, 1, "--row");
  refused({"--epi", drawn.epi, "--row", "24"}, 1, "--row: the result has 0 to 23, got 24");
  refused({"--epi", drawn.epi, "--row", "-1"}, 1, "--row");
  refused({"--epi", drawn.epi, "--row", "3", "--face", "6"}, 1, "--face: the result has 0 to 5, got 6");
  refused({"--epi", drawn.epi, "--row", "3", "--segment", "1"}, 1, "--segment: the result has 0 to 0, got 1");
  refused({"--row", "3"}, 1, "--epi");
  const std::string whole = read_text(drawn.result);
  std::ofstream(drawn.result) << whole.substr(0, whole.size() / 2);
  refused({"--epi", drawn.epi, "--row", "3"}, 2, "r.json");
  // A result that does not hold what the row sees is not that of the query.
  nlohmann::json other = nlohmann::json::parse(whole);
  other["visible"] = {0};
  other["counts"] = {{"visible", 1}, {"hidden", 3}, {"undecided", 0}};
  other["seen"] = nlohmann::json::array({nlohmann::json(other["seen"][0])});
  std::ofstream(drawn.result) << other.dump();
  refused({"--epi", drawn.epi, "--row", "13", "--face", "5"}, 2, "does not hold primitive");
  REQUIRE(
      provis_run({"point", drawn.scene, "--eye", "0,0,0", "--dir", "0,0,-1", "--out", drawn.result}).status ==
      0);
  refused({"--epi", drawn.epi, "--row", "3"}, 2, "provis segment");
}
