// glTF scenes, poses and nodes, from the command line to the result and back.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "provis/result_file.hpp"
#include "provis/scene.hpp"
#include "tests/cli/child.hpp"
#include "tests/scene/gltf_builder.hpp"

using namespace provis;
using namespace provis::test;

namespace {

/// One mesh. Scene 0 places it by node 0 "door", which two animations move, and by node 1 "door"; scene 1,
/// called night, by node 2 "wall". Animation 0 "rise" moves node 0 up by 1 a second, 1 "slide" aside by 2.
std::string write_house(const std::filesystem::path& file) {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions<float>({-1, -1, -5, 1, -1, -5, 0, 1, -5}));
  builder.root({{"name", "door"}, {"mesh", mesh}});
  builder.root({{"name", "door"}, {"mesh", mesh}, {"translation", {0, 10, 0}}});
  builder.add("nodes", {{"name", "wall"}, {"mesh", mesh}, {"scale", {2, 2, 2}}});
  builder.add("nodes", {{"name", "empty"}});
  builder.add("scenes", {{"name", "night"}, {"nodes", {2, 3}}});
  const auto animate = [&](const char* name, const std::vector<float>& end) {
    const int input = builder.indices<float>({0, 10});
    builder.json["accessors"][input].update({{"min", {0}}, {"max", {10}}});
    const int output = builder.accessor<float>("VEC3", 3, {0, 0, 0, end[0], end[1], end[2]});
    builder.add("animations",
                {{"name", name},
                 {"samplers", {{{"input", input}, {"output", output}}}},
                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  };
  animate("rise", {0, 10, 0});
  animate("slide", {20, 0, 0});
  std::ofstream(file, std::ios::binary) << builder.glb();
  return file.string();
}

struct House {
  TempFolder directory;
  std::string file = write_house(directory.path() / "house.glb");

  std::string path(const std::string& name) const { return (directory.path() / name).string(); }
  Outcome info(Words more) const {
    more.insert(more.begin(), {"info", file});
    return provis_run(more);
  }
};

}  // namespace

TEST_CASE("info lists scenes and animations, and which were taken") {
  const House house;
  const Outcome rest = house.info({});
  CHECK_THAT(rest.out, Catch::Contains("loaded     scene 0 of 2\n") &&
                           Catch::Contains("animation  1 \"slide\", 0 to 10 s, not applied\n"));
  const Outcome posed = house.info({"--time", "2.5", "--animation", "slide"});
  CHECK_THAT(posed.out, Catch::Contains("animation  0 \"rise\", 0 to 10 s, not applied\n") &&
                            Catch::Contains("animation  1 \"slide\", 0 to 10 s, applied\n") &&
                            Catch::Contains("animation slide, ") && Catch::Contains(", time 2.5\n"));
  const auto json = Json::parse(house.info({"--scene", "1", "--json"}).out);
  CHECK(json["scenes"][1] == Json{{"index", 1}, {"name", "night"}, {"loaded", true}});
  CHECK(json["unit"] == "metre");
  CHECK(json["sources"][0]["node"] == 2);
}

TEST_CASE("a pose moves the corners, by number or by name of the animation") {
  const House house;
  const auto corner = [&](Words more) {
    more.insert(more.end(), {"--source", "0", "--json"});
    return Json::parse(house.info(more).out)["corners"][0];
  };
  CHECK(corner({}) == Json::array({-1.0, -1.0, -5.0}));
  CHECK(corner({"--time", "2"}) == Json::array({-1.0, 1.0, -5.0}));
  CHECK(corner({"--time", "2", "--animation", "1"}) == Json::array({3.0, -1.0, -5.0}));
  CHECK(corner({"--time", "99", "--animation", "slide"}) == Json::array({19.0, -1.0, -5.0}));
  CHECK(corner({"--scene", "1"}) == Json::array({-2.0, -2.0, -10.0}));
}

TEST_CASE("the ids of nodes, and what is said where a name is no single node with primitives") {
  const House house;
  const Outcome both = house.info({"--ids-of", "door"});
  CHECK(both.status == 0);
  CHECK(both.out == "0-1\n");
  CHECK_THAT(both.err, Catch::Contains("2 nodes are called \"door\": 0, 1"));
  const Outcome one = house.info({"--ids-of", "1"});
  CHECK(one.out == "1-1\n");
  CHECK(one.err.empty());
  const auto json = Json::parse(house.info({"--ids-of", "1", "--json"}).out);
  CHECK(json["ranges"] == Json::array({Json::array({1, 1})}));
  const Outcome elsewhere = house.info({"--ids-of", "wall"});
  CHECK(elsewhere.status == 0);
  CHECK(elsewhere.out.empty());
  CHECK_THAT(elsewhere.err, Catch::Contains("node 2 holds no primitives"));
  CHECK(house.info({"--ids-of", "wall", "--scene", "1"}).out == "0-0\n");
  for (const char* none : {"Door", "4"}) {
    const Outcome outcome = house.info({"--ids-of", none});
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Catch::Contains(none));
  }
}

TEST_CASE("a result of a pose records it, and is drawn from it") {
  const House house;
  const std::string result = house.path("r.json"), picture = house.path("p.png");
  const Outcome asked = provis_run({"point", house.file, "--eye", "0,0,0", "--dir", "0,0,-1", "--time", "0.1",
                                    "--animation", "slide", "--sides", "both", "--out", result});
  REQUIRE(asked.status == 0);
  const ResultFile recorded = read_result(result);
  CHECK(recorded.header.options.at("time") == "0.1");
  CHECK(recorded.header.options.at("animation") == "slide");
  CHECK(recorded.header.options.count("scene") == 0);
  LoadOptions options;
  options.sides = Sides::both;
  options.time = 0.1;
  options.animation = "slide";
  CHECK(recorded.header.scene_hash == load_scene(house.file, options).hash());
  CHECK(recorded.header.scene_hash != load_scene(house.file, {Sides::both, Opacity::material}).hash());
  CHECK(provis_run({"draw", house.file, result, "--above", picture}).status == 0);
  CHECK(std::filesystem::exists(picture));
}

TEST_CASE("a broken primitive of a glTF file is left out, listed and loaded without again") {
  const TempFolder directory;
  const std::string file = (directory.path() / "broken.glb").string(),
                    result = (directory.path() / "r.json").string();
  GltfBuilder builder = one_triangle();
  builder.root({{"mesh", builder.mesh(99)}});
  std::ofstream(file, std::ios::binary) << builder.glb();
  const Words ask = {"point", file, "--eye", "0,0,3", "--dir", "0,0,-1", "--out", result};
  CHECK(provis_run(ask).status == 2);
  Words skipping = ask;
  skipping.push_back("--skip-invalid");
  const Outcome outcome = provis_run(skipping);
  CHECK(outcome.status == 0);
  CHECK_THAT(outcome.err, Catch::Contains("left out 1 invalid primitives") && Catch::Contains("meshes[1]"));
  const ResultFile recorded = read_result(result);
  REQUIRE(recorded.header.left_out.size() == 1);
  CHECK(recorded.header.triangles == 1);
  CHECK(provis_run({"draw", file, result, "--above", (directory.path() / "p.png").string()}).status == 0);
}

TEST_CASE("what the file does not have is named") {
  const House house;
  const auto refused = [&](const Words& more, const std::string& option) {
    const Outcome outcome = house.info(more);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Catch::Contains(option));
  };
  refused({"--scene", "2"}, "--scene");
  refused({"--time", "1", "--animation", "fall"}, "--animation");
  refused({"--time", "1", "--animation", "7"}, "--animation");
}
