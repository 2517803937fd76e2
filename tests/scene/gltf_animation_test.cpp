// Nodes at a time: interpolations, clamping, which animation, and what is wrong with broken ones.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "tests/scene/gltf_builder.hpp"

namespace provis {
namespace {

LoadOptions at(double time, const std::string& animation = "") {
  LoadOptions options;
  options.time = time;
  options.animation = animation;
  return options;
}

/// What a channel of a test animates.
struct Track {
  const char* path = "translation";
  const char* interpolation = "LINEAR";
  std::vector<float> times = {1, 3};
  std::vector<float> values = {10, 0, 0, 20, 0, 0};
};

const char* type_of(const Track& track) {
  const std::string path = track.path;
  if (path == "rotation") return "VEC4";
  return path == "weights" ? "SCALAR" : "VEC3";
}

std::size_t components_of(const Track& track) {
  const std::string path = track.path;
  if (path == "rotation") return 4;
  return path == "weights" ? 1 : 3;
}

/// Adds an animation of one channel that drives that node, and returns its index.
int animate(GltfBuilder& builder, const Track& track, int node = 0) {
  const int input = builder.indices(track.times);
  const int output = builder.accessor(type_of(track), components_of(track), track.values);
  return builder.add(
      "animations",
      {{"samplers", {{{"input", input}, {"output", output}, {"interpolation", track.interpolation}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", track.path}}}}}}});
}

GltfBuilder animated_triangle(const Track& track) {
  GltfBuilder builder = one_triangle();
  animate(builder, track);
  return builder;
}

/// The vertices of a triangle whose node stands as given.
std::vector<Vec3d> placed(const Json& node) {
  const Scene scene = one_triangle(Json::object(), node).load();
  return {scene.vertices().begin(), scene.vertices().end()};
}

std::vector<Vec3d> posed(const Track& track, double time) {
  const Scene scene = animated_triangle(track).load(at(time));
  return {scene.vertices().begin(), scene.vertices().end()};
}

TEST_CASE("LINEAR moves on a line, and stops at the ends") {
  const Track track;
  CHECK(posed(track, 2)[0] == Vec3d{15, 0, 0});
  CHECK(posed(track, 1.5)[0] == Vec3d{12.5, 0, 0});
  CHECK(posed(track, 1)[0] == Vec3d{10, 0, 0});
  CHECK(posed(track, 3)[0] == Vec3d{20, 0, 0});
  CHECK(posed(track, 0)[0] == Vec3d{10, 0, 0});
  CHECK(posed(track, -7)[0] == Vec3d{10, 0, 0});
  CHECK(posed(track, 1e300)[0] == Vec3d{20, 0, 0});
  CHECK(animated_triangle(track).load().vertices()[0] == Vec3d{0, 0, 0});
}

TEST_CASE("STEP keeps the key's value until the next key") {
  const Track track{"scale", "STEP", {1, 2, 4}, {2, 2, 2, 3, 3, 3, 4, 4, 4}};
  CHECK(posed(track, 0.5)[1] == Vec3d{2, 0, 0});
  CHECK(posed(track, std::nextafter(2.0, 0.0))[1] == Vec3d{2, 0, 0});
  CHECK(posed(track, 2)[1] == Vec3d{3, 0, 0});
  CHECK(posed(track, 3.9)[1] == Vec3d{3, 0, 0});
  CHECK(posed(track, 4)[1] == Vec3d{4, 0, 0});
}

TEST_CASE("CUBICSPLINE follows its tangents, which lie around each value") {
  // In-tangent, value, out-tangent. Half way through 2 s: 10/2 + 4/4 + 20/2 - 8/4.
  const Track track{
      "translation", "CUBICSPLINE", {1, 3}, {99, 0, 0, 10, 0, 0, 4, 0, 0, 8, 0, 0, 20, 0, 0, 99, 0, 0}};
  CHECK(posed(track, 2)[0] == Vec3d{14, 0, 0});
  CHECK(posed(track, 1)[0] == Vec3d{10, 0, 0});
  CHECK(posed(track, 3)[0] == Vec3d{20, 0, 0});
  CHECK(posed(track, 9)[0] == Vec3d{20, 0, 0});
  // A quarter: u2 = 1/16, u3 = 1/64; all coefficients are dyadic: 27/32, 2 * 9/64, 5/32, 2 * -3/64.
  CHECK(posed(track, 1.5)[0] == Vec3d{10 * 27.0 / 32 + 4 * 18.0 / 64 + 20 * 5.0 / 32 - 8 * 6.0 / 64, 0, 0});
}

TEST_CASE("one key holds at all times") {
  for (const double time : {0.0, 1.0, 2.0}) {
    CHECK(posed({"translation", "LINEAR", {1}, {5, 6, 7}}, time)[0] == Vec3d{5, 6, 7});
    CHECK(posed({"translation", "CUBICSPLINE", {1}, {9, 9, 9, 5, 6, 7, 9, 9, 9}}, time)[0] == Vec3d{5, 6, 7});
  }
}

TEST_CASE("LINEAR rotations turn evenly, by the shorter way") {
  const double k = std::sqrt(0.5);
  const std::vector<Vec3d> half = placed({{"rotation", {0, 0, k, k}}});
  CHECK(posed({"rotation", "LINEAR", {0, 2}, {0, 0, 0, 1, 0, 0, 1, 0}}, 1) == half);
  // -q1 is the same rotation by the longer way round; c = -0.8 tells.
  const std::vector<float> near = {0, 0, 0, 1, 0, 0, 0.6f, 0.8f}, far = {0, 0, 0, 1, 0, 0, -0.6f, -0.8f};
  CHECK(posed({"rotation", "LINEAR", {0, 2}, near}, 0.7) == posed({"rotation", "LINEAR", {0, 2}, far}, 0.7));
}

TEST_CASE("rotations that are parallel as computed move on a line") {
  // c = 4: 3/4 of q0 and 1/4 of q1, as stored.
  CHECK(posed({"rotation", "LINEAR", {0, 4}, {0, 0, 0, 1, 0, 0, 2, 4}}, 1) ==
        placed({{"rotation", {0, 0, 0.5, 1.75}}}));
  CHECK(posed({"rotation", "LINEAR", {0, 4}, {0, 0, 0, 1, 0, 0, -2, -4}}, 1) ==
        placed({{"rotation", {0, 0, 0.5, 1.75}}}));
}

TEST_CASE("a parameter that rounds to the end is the end") {
  // Just below the second key (T - t0) / d rounds to 1, so that the factors are 0 and 1.
  const double time = std::nextafter(1.0, 0.0);
  CHECK(posed({"rotation", "LINEAR", {-1, 1}, {0, 0, 0, 1, 0, 0, 0.6f, 0.8f}}, time) ==
        placed({{"rotation", {0, 0, double{0.6f}, double{0.8f}}}}));
}

TEST_CASE("CUBICSPLINE rotations are normalised between keys and as stored at them") {
  const std::vector<float> zero = {0, 0, 0, 0}, q0 = {0, 0, 0, 2}, q1 = {0, 0, 2, 0};
  Track track{"rotation", "CUBICSPLINE", {0, 2}, {}};
  for (const auto& part : {zero, q0, zero, zero, q1, zero})
    track.values.insert(track.values.end(), part.begin(), part.end());
  // Half way it is (0, 0, 1, 1), whose length is the root of 2.
  const double k = 1 / std::sqrt(2.0);
  CHECK(posed(track, 1) == placed({{"rotation", {0, 0, k, k}}}));
  CHECK(posed(track, 0) == placed({{"rotation", {0, 0, 0, 2}}}));
  CHECK(posed(track, 2) == placed({{"rotation", {0, 0, 2, 0}}}));
  track.times = {0, 2, 3};
  for (const auto& part : {zero, q0, zero}) track.values.insert(track.values.end(), part.begin(), part.end());
  CHECK(posed(track, 2) == placed({{"rotation", {0, 0, 2, 0}}}));
  CHECK(posed(track, 2.5) == placed({{"rotation", {0, 0, k, k}}}));
}

TEST_CASE("rotations may be normalised integers") {
  GltfBuilder builder = one_triangle();
  animate(builder, {"rotation", "LINEAR", {0}, {0, 0, 0, 1}});
  builder.json["animations"][0]["samplers"][0]["output"] =
      builder.normalized<std::int16_t>("VEC4", 4, {0, 0, 32767, -32768});
  const Scene scene = builder.load(at(0));
  CHECK(std::vector<Vec3d>(scene.vertices().begin(), scene.vertices().end()) ==
        placed({{"rotation", {0, 0, 1, -1}}}));
  builder.json["accessors"].back().erase("normalized");
  CHECK_FAILURE(builder.failure(at(0)), 2, "accessors[3]");
}

TEST_CASE("what is not animated stays, and children follow") {
  GltfBuilder builder;
  const int mesh = builder.mesh(builder.positions<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
  const int child = builder.add("nodes", {{"mesh", mesh}, {"translation", {0, 5, 0}}});
  const int parent = builder.root({{"children", {child}}, {"scale", {2, 2, 2}}, {"translation", {7, 7, 7}}});
  animate(builder, {}, parent);
  CHECK(builder.load(at(2)).vertices()[1] == Vec3d{17, 10, 0});
}

TEST_CASE("samplers end at their own times") {
  GltfBuilder builder = one_triangle();
  animate(builder, {"translation", "LINEAR", {0, 10}, {0, 0, 0, 10, 0, 0}});
  animate(builder, {"scale", "LINEAR", {0, 1}, {1, 1, 1, 2, 2, 2}});
  Json& first = builder.json["animations"][0];
  const Json second = builder.json["animations"][1];
  first["samplers"].push_back(second["samplers"][0]);
  first["channels"].push_back({{"sampler", 1}, {"target", {{"node", 0}, {"path", "scale"}}}});
  CHECK(builder.load(at(4)).vertices()[1] == Vec3d{6, 0, 0});
}

GltfBuilder three_animations() {
  GltfBuilder builder = one_triangle();
  for (const float x : {1.0f, 2.0f, 3.0f}) animate(builder, {"translation", "LINEAR", {0}, {x, 0, 0}});
  builder.json["animations"][0]["name"] = "Walk";
  builder.json["animations"][1]["name"] = "0";
  builder.json["animations"][2]["name"] = "Run";
  return builder;
}

TEST_CASE("the animation is the first, the one of that name, or the one of that index") {
  const GltfBuilder builder = three_animations();
  CHECK(builder.load(at(0)).vertices()[0].x == 1);
  CHECK(builder.load(at(0, "Run")).vertices()[0].x == 3);
  CHECK(builder.load(at(0, "2")).vertices()[0].x == 3);
  CHECK(builder.load(at(0, "0")).vertices()[0].x == 2);
  CHECK(builder.load(at(0, "2")).notes().animation == 2);
  CHECK(builder.load().notes().animation == -1);
}

TEST_CASE("an animation that cannot be told is a usage error") {
  GltfBuilder builder = three_animations();
  const Failure unknown = builder.failure(at(0, "Fly"));
  CHECK_FAILURE(unknown, 1, "--animation");
  CHECK_THAT(unknown.message, Catch::Contains("0 \"Walk\", 1 \"0\", 2 \"Run\""));
  CHECK_FAILURE(builder.failure(at(0, "3")), 1, "--animation");
  CHECK_FAILURE(builder.failure(at(0, "-1")), 1, "--animation");
  CHECK_FAILURE(builder.failure(at(0, "1x")), 1, "--animation");
  builder.json["animations"][2]["name"] = "Walk";
  const Failure ambiguous = builder.failure(at(0, "Walk"));
  CHECK_FAILURE(ambiguous, 1, "--animation");
  CHECK_THAT(ambiguous.message, Catch::Contains("2 animations are called \"Walk\""));
  LoadOptions no_time;
  no_time.animation = "0";
  CHECK_FAILURE(builder.failure(no_time), 1, "--animation");
}

TEST_CASE("a time needs an animation and must be a number") {
  CHECK_FAILURE(one_triangle().failure(at(0)), 1, "--time");
  GltfBuilder none = one_triangle();
  none.json["animations"] = Json::array();
  CHECK_FAILURE(none.failure(at(0)), 1, "--time");
  CHECK_FAILURE(three_animations().failure(at(std::nan(""))), 1, "--time");
  CHECK_FAILURE(three_animations().failure(at(std::numeric_limits<double>::infinity())), 1, "--time");
}

/// Of an animated triangle after a change.
Failure after(void (*change)(Json&), const Track& track = {}) {
  GltfBuilder builder = animated_triangle(track);
  change(builder.json);
  CHECK(builder.failure().status == 0);  // without a time nobody looks
  return builder.failure(at(2));
}

TEST_CASE("broken members of the animation that is asked for are errors that name them") {
  CHECK(after([](Json&) {}).status == 0);
  const std::string channel = "animations[0].channels[0]", sampler = "animations[0].samplers[0]";
  CHECK_FAILURE(after([](Json& j) { j["animations"] = 3; }), 2, "animations");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0] = 3; }), 2, "animations[0]");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0].erase("channels"); }), 2, "animations[0]");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["samplers"] = 1; }), 2, "animations[0].samplers");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["channels"][0].erase("target"); }), 2, channel);
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["channels"][0]["sampler"] = 1; }), 2, channel);
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["channels"][0]["sampler"] = "0"; }), 2,
                channel + ".sampler");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["channels"][0]["target"]["node"] = 7; }), 2, channel);
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["channels"][0]["target"]["path"] = "colour"; }), 2,
                channel + ".target.path");
  CHECK_FAILURE(
      after([](Json& j) { j["animations"][0]["channels"].push_back(j["animations"][0]["channels"][0]); }), 2,
      "animations[0].channels[1]");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["samplers"][0].erase("input"); }), 2, sampler);
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["samplers"][0]["input"] = 9; }), 2,
                sampler + ".input");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["samplers"][0]["output"] = 9; }), 2,
                sampler + ".output");
  CHECK_FAILURE(after([](Json& j) { j["animations"][0]["samplers"][0]["interpolation"] = "BEZIER"; }), 2,
                sampler + ".interpolation");
}

TEST_CASE("keys must grow, be finite, and have one value each") {
  const float infinity = std::numeric_limits<float>::infinity();
  const Failure stands = after([](Json&) {}, {"translation", "LINEAR", {1, 1}, {0, 0, 0, 0, 0, 0}});
  CHECK_FAILURE(stands, 2, "accessors[1]");
  CHECK_THAT(stands.message, Catch::Contains("element 1"));
  CHECK_FAILURE(after([](Json&) {}, {"translation", "LINEAR", {1, 0}, {0, 0, 0, 0, 0, 0}}), 2,
                "accessors[1]");
  CHECK_FAILURE(after([](Json&) {}, {"translation", "LINEAR", {1, infinity}, {0, 0, 0, 0, 0, 0}}), 2,
                "accessors[1]");
  CHECK_FAILURE(after([](Json&) {}, {"translation", "LINEAR", {}, {}}), 2, "accessors[1]");
  CHECK_FAILURE(after([](Json&) {}, {"translation", "LINEAR", {1, 2}, {0, 0, 0}}), 2,
                "animations[0].samplers[0]");
  CHECK_FAILURE(after([](Json&) {}, {"translation", "CUBICSPLINE", {1, 2}, {0, 0, 0, 0, 0, 0}}), 2,
                "animations[0].samplers[0]");
  CHECK_FAILURE(after([](Json&) {}, {"translation", "LINEAR", {1, 3}, {0, infinity, 0, 0, 0, 0}}), 2,
                "accessors[2]");
  CHECK_FAILURE(after([](Json& j) { j["accessors"][1]["componentType"] = 5125; }), 2, "accessors[1]");
  CHECK_FAILURE(after([](Json& j) { j["accessors"][2]["type"] = "VEC2"; }), 2, "accessors[2]");
}

TEST_CASE("a spline that passes through no rotation has no value there") {
  // From (0,0,0,1) to (0,0,0,-1) without tangents: zero half way.
  std::vector<float> values(24, 0.0f);
  values[7] = 1, values[19] = -1;
  CHECK_FAILURE(after([](Json&) {}, {"rotation", "CUBICSPLINE", {1, 3}, values}), 2,
                "animations[0].samplers[0]");
}

TEST_CASE("a node with a matrix cannot be animated") {
  CHECK_FAILURE(
      after([](Json& j) { j["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}; }), 2,
      "nodes[0]");
}

TEST_CASE("weights of a node without morph targets cannot be animated") {
  CHECK_FAILURE(after([](Json&) {}, {"weights", "LINEAR", {1, 3}, {0, 1}}), 2, "animations[0].channels[0]");
}

TEST_CASE("a channel without a node is ignored, one that points into the document is unsupported") {
  const auto without_node = [](Json& j) {
    Json& channel = j["animations"][0]["channels"][0];
    channel["target"] = {{"path", "colour"}};
    channel["sampler"] = 44;
  };
  CHECK(after(without_node).status == 0);
  CHECK_FAILURE(after([](Json& j) {
                  j["animations"][0]["channels"][0]["target"] = {{"path", "pointer"}};
                }),
                3, "animations[0].channels[0]");
}

TEST_CASE("other animations may be broken") {
  GltfBuilder builder = three_animations();
  builder.json["animations"][0] = "broken";
  builder.json["animations"][2]["samplers"][0]["input"] = 99;
  CHECK(builder.load(at(0, "1")).vertices()[0].x == 2);
  CHECK(builder.failure(at(0)).status == 2);
}

TEST_CASE("notes tell names and times as far as the JSON does") {
  GltfBuilder builder = three_animations();
  for (Json& a : builder.json["animations"]) {
    Json& input = builder.json["accessors"][a["samplers"][0]["input"].get<int>()];
    input["min"] = {0.5};
    input["max"] = {2};
  }
  builder.json["scenes"][0]["name"] = "main";
  builder.json["animations"][1]["samplers"][0].erase("input");
  builder.json["buffers"] = {{{"byteLength", builder.binary.size()}},
                             {{"byteLength", 1}, {"uri", "none.bin"}}};
  const FileNotes notes = builder.load().notes();
  CHECK((notes.format == "glTF" && notes.unit == "metre" && notes.scene == 0));
  CHECK(notes.scenes == std::vector<std::string>{"main"});
  REQUIRE(notes.animations.size() == 2);
  CHECK((notes.animations[0].name == "Walk" && notes.animations[0].index == 0));
  CHECK((notes.animations[0].first == 0.5 && notes.animations[0].last == 2));
  CHECK((notes.animations[1].name == "Run" && notes.animations[1].index == 2));
  builder.json["accessors"][1]["min"] = {"early"};
  CHECK(builder.load().notes().animations.size() == 1);
  builder.json["animations"] = "none";
  CHECK(builder.load().notes().animations.empty());
}

}  // namespace
}  // namespace provis
