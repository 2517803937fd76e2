// The report on what accuracy costs: shares by number and by area, and how they are told.

#include "src/report/accuracy.hpp"

#include <catch2/catch.hpp>
#include <sstream>

#include "provis/error.hpp"
#include "tests/report/example_result.hpp"
#include "tests/report/schema.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using Json = nlohmann::json;

namespace {

constexpr Status in = Status::visible, out = Status::hidden;

WayOutcome outcome(const Way& way, double seconds, SetScore score) {
  WayOutcome o;
  o.way = way;
  o.ending = Ending::done;
  o.cpu_seconds = {seconds, seconds / 2, 2 * seconds};
  o.wall_seconds = o.cpu_seconds;
  o.peak_bytes = {3 << 20, 2 << 20, 4 << 20};
  o.visible = 100 - score.wrong_out + score.wrong_in;
  o.score = score;
  o.signs.at(Predicate::turn, Tier::filter) = 1000;
  return o;
}

AccuracyReport example() {
  AccuracyReport report;
  report.header = example_result().header;
  report.header.options = {
      {"sides", "material"}, {"opacity", "all"}, {"perturb", "0"}, {"seed", "0"}, {"size", "8x8"}};
  report.runs = 3;
  report.time_limit = 60;
  report.threads = 2;
  report.reference = Way{};
  report.area = AreaMeasure::subdivision;
  report.outcomes.push_back(outcome({Method::exact, Arithmetic::doubles, 1}, 0.5, {2, 1, 0.01, 1e-7}));
  report.outcomes.back().wrong_signs = 7;
  report.outcomes.push_back(outcome({}, 1, {}));
  report.outcomes.push_back(outcome({Method::sampled, Arithmetic::chain, 4}, 0.1, {0, 30, 0.3, 0.02}));
  WayOutcome& late = report.outcomes.emplace_back();
  late.way = {Method::exact, Arithmetic::mpfr, 1};
  late.ending = Ending::timed_out;
  WayOutcome& crashed = report.outcomes.emplace_back();
  crashed.way = {Method::aggressive, Arithmetic::chain, 1};
  crashed.ending = Ending::crashed;
  crashed.reason = "signal 11, Segmentation fault";
  return report;
}

AccuracyReport along_a_segment() {
  AccuracyReport report = example();
  report.header.options.erase("size");
  SegmentQuery query;
  query.paths = {{{0, 0, 0}, {1, 2, 3}}};
  query.frames = omni({0, 0, 0}).frames;
  query.pixels = {32, 32};
  report.header.segments = query;
  report.area = AreaMeasure::sight;
  report.outcomes.resize(2);
  report.outcomes.push_back(outcome({Method::exact, Arithmetic::chain, 1, 0, true}, 4, {}));
  report.outcomes.push_back(outcome({Method::exact, Arithmetic::doubles, 1, 0, true}, 3, {}));
  report.outcomes.push_back(outcome({Method::sampled, Arithmetic::doubles, 1, 10}, 0.75, {0, 30, 0.3, 0.02}));
  report.outcomes.push_back(
      outcome({Method::sampled, Arithmetic::doubles, 1, 100}, 7.5, {0, 1, 0.01, 0.001}));
  report.outcomes.push_back(outcome({Method::sampled, Arithmetic::doubles, 1, 1000}, 75, {}));
  return report;
}

Way cell_way(CellMethod method, int viewpoints = 0, const PixelGrid& pixels = {0, 0}) {
  return {Method::exact, Arithmetic::chain, 1, viewpoints, false, method, pixels};
}

AccuracyReport from_a_cell() {
  AccuracyReport report = example();
  report.header.cell = cell_around({1, 2, 3}, {0.5, 0.5, 0.5});
  report.header.triangles = 300;
  report.reference = {};
  report.area = AreaMeasure::none;
  report.known = KnownOfCell{100, 120};
  report.outcomes.clear();
  const auto grid = [&](int n, SetScore score) {
    report.outcomes.push_back(
        outcome({Method::sampled, Arithmetic::doubles, n, n * n * n, false, {}, {64, 64}}, 0.1 * n, score));
  };
  grid(2, {0, 20, 0.2, 0});
  grid(6, {3, 5, 0.05, 0});
  grid(10, {4, 2, 0.02, 0});
  report.outcomes.push_back(outcome(cell_way(CellMethod::lower, 10), 1, {0, 1, 0.01, 0}));
  report.outcomes.push_back(outcome(cell_way(CellMethod::cos, 0, {25, 13}), 2, {}));
  report.outcomes.back().score.reset();
  report.outcomes.back().excess = SetExcess{130, 30, 0.3};
  report.outcomes.push_back(outcome(cell_way(CellMethod::bounds), 3, {}));
  report.outcomes.back().excess = SetExcess{120, 20, 0.2};
  return report;
}

Json written(const AccuracyReport& report) {
  std::stringstream text;
  write_accuracy_json(report, text);
  return Json::parse(text.str());
}

std::string drawn(const AccuracyReport& report) {
  std::stringstream text;
  write_accuracy_picture(report, text);
  return text.str();
}

Json schema() {
  return Json::parse(read_text(std::string(PROVIS_SOURCE_DIR) + "/src/report/accuracy.schema.json"));
}

/// A triangle in the plane z = -1, seen from the origin along -z.
Scene triangle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  SceneArrays arrays;
  arrays.vertices = {a, b, c};
  arrays.triangles = {{0, 1, 2}};
  arrays.triangle_flags = {0};
  return Scene(arrays);
}

double projected(const Scene& scene, Projection projection = Projection::pinhole) {
  const auto parts = projected_parts(scene, {{0, 0, 0}, projection, {Frame{}}}, {in});
  REQUIRE(parts.size() == 1);
  return parts[0].area;
}

}  // namespace

TEST_CASE("a score counts both kinds of error, and the area of what is not shown") {
  const std::vector<ImagePart> image = {{1, {0}}, {2, {1, 2}}, {4, {3}}, {8, {}}};
  const std::vector<Status> exact = {in, in, in, in, out};
  const SetScore all = score(exact, exact, image);
  CHECK(all.wrong_in == 0);
  CHECK(all.wrong_out == 0);
  CHECK(all.set_missed == 0);
  CHECK(all.area_missed == 0);
  // A part where two are seen is not shown if one of them is missing; one in excess hides nothing.
  const SetScore some = score({out, in, out, in, in}, exact, image);
  CHECK(some.wrong_in == 1);
  CHECK(some.wrong_out == 2);
  CHECK(some.set_missed == 0.5);
  CHECK(some.area_missed == 3.0 / 15);
  CHECK(score({out}, {out}, {}).area_missed == 0);
}

TEST_CASE("the projected area of a triangle is that of its image within the window") {
  CHECK(projected(triangle({0, 0, -1}, {1, 0, -1}, {0, 1, -1})) == 0.5);
  CHECK(projected(triangle({0, 0, -2}, {2, 0, -2}, {0, 2, -2})) == 0.5);
  // Twice the window's half, cut off at its borders; and all of the window.
  CHECK(projected(triangle({-2, -2, -1}, {2, -2, -1}, {-2, 2, -1})) == 2);
  CHECK(projected(triangle({-9, -9, -1}, {9, -9, -1}, {0, 9, -1})) == 4);
  // Behind the eye, beside the window, and through the eye's plane: a floor of which the lower half is seen.
  CHECK(projected(triangle({0, 0, 1}, {1, 0, 1}, {0, 1, 1})) == 0);
  CHECK(projected(triangle({2, 0, -1}, {3, 0, -1}, {2, 1, -1})) == 0);
  CHECK(projected(triangle({-1e6, -1, 1e6}, {1e6, -1, 1e6}, {0, -1, -1e9})) == Approx(2).epsilon(1e-3));
  // An eye at infinity: sizes as they are, and nothing of what lies before the window.
  CHECK(projected(triangle({0, 0, -5}, {1, 0, -5}, {0, 1, -5}), Projection::parallel) == 0.5);
  CHECK(projected(triangle({0, 0, 5}, {1, 0, 5}, {0, 1, 5}), Projection::parallel) == 0);
}

TEST_CASE("the median of an even number of runs lies in the middle of two") {
  CHECK(spread({3, 1, 2}).median == 2);
  CHECK(spread({4, 1, 2, 3}).median == 2.5);
  CHECK(spread({4, 1, 2, 3}).least == 1);
  CHECK(spread({4, 1, 2, 3}).most == 4);
}

TEST_CASE("the price of certainty is told, with what doubles got wrong") {
  AccuracyReport report = example();
  CHECK(price_of_certainty(report)->ratio == 2);
  CHECK_THAT(accuracy_text(report),
             Catch::EndsWith("certainty  doubles gave another set (2 in, 1 out); 2.00 times its CPU time\n"));
  report.outcomes[0].score = SetScore{};
  CHECK_THAT(
      accuracy_text(report),
      Catch::EndsWith("certainty  2.00 times the CPU time of plain doubles, which gave the same set\n"));
  report.outcomes[1].ending = Ending::out_of_memory;
  CHECK_FALSE(price_of_certainty(report));
}

TEST_CASE("the table tells what ended how") {
  const std::string text = accuracy_text(example());
  CHECK_THAT(text, Catch::Contains("mpfr             timed out\n"));
  CHECK_THAT(text, Catch::Contains("aggressive       crashed: signal 11, Segmentation fault\n"));
  CHECK_THAT(text, Catch::Contains("sampled 4x4       0.100   0.050 to 0.200    0.100      3.0        70"));
  CHECK_THAT(text, Catch::Contains("30 %          2 %\n"));
}

TEST_CASE("an area that is not that of the image is not called so") {
  AccuracyReport report = example();
  report.area = AreaMeasure::projection;
  report.no_subdivision = "timed out";
  CHECK_THAT(accuracy_text(report), Catch::Contains("not that of the image: the subdivision timed out"));
  CHECK_THAT(drawn(report), Catch::Contains("Projected area missed"));
  CHECK_THAT(drawn(example()), Catch::Contains("Image area missed"));
  CHECK(written(report)["area"] == Json{{"measure", "projection"}, {"no_subdivision", "timed out"}});
}

TEST_CASE("the report is valid JSON by its schema, whatever is missing") {
  CHECK(schema_violations(schema(), written(example())) == std::vector<std::string>{});
  AccuracyReport bare;
  bare.header = example().header;
  bare.outcomes = {WayOutcome{}};
  CHECK(schema_violations(schema(), written(bare)) == std::vector<std::string>{});
  Json bad = written(example());
  bad["ways"][0].erase("score");
  CHECK_FALSE(schema_violations(schema(), bad).empty());
}

TEST_CASE("a scene's name is text in the picture, not markup") {
  AccuracyReport report = example();
  report.header.scene_file = "a<b>&c.glb";
  CHECK_THAT(drawn(report), Catch::Contains("a&lt;b&gt;&amp;c.glb"));
}

TEST_CASE("along a segment the report tells the engines apart, and what sampling finds in how much time") {
  const AccuracyReport report = along_a_segment();
  CHECK(price_of_certainty(report)->ratio == 2);
  const std::string text = accuracy_text(report);
  CHECK_THAT(text, Catch::Contains("segment from 0,0,0 to 1,2,3, 6 frames of 32x32 pixels"));
  CHECK_THAT(text, Catch::Contains("sight missed") && !Catch::Contains("area missed"));
  CHECK_THAT(text, Catch::Contains("\nchain (plain) ") && Catch::Contains("\nsampled 1000 "));
  CHECK_THAT(text, Catch::EndsWith("which gave the same set\n") || Catch::EndsWith("than the chain\n"));
  CHECK_THAT(text, Catch::Contains(
                       "sampling   99 % of the set from 100 viewpoints, in 7.5 times the CPU time of "
                       "the chain\n           70 % of the set from 10 viewpoints in no more time than the "
                       "chain\n"));
  const std::string svg = drawn(report);
  CHECK_THAT(svg, Catch::Contains("Pixels x time missed") &&
                      Catch::Contains("viewpoints along the segment") && Catch::Contains("plain engine"));
  CHECK_THAT(svg, !Catch::Contains("aggressive") && !Catch::Contains("²"));
  CHECK_THAT(drawn(example()), !Catch::Contains("viewpoints along") && Catch::Contains("aggressive"));
}

TEST_CASE("what sampling does not reach is not called reached") {
  AccuracyReport report = along_a_segment();
  report.outcomes.resize(report.outcomes.size() - 2);
  report.outcomes.back().cpu_seconds.median = 1.5;
  CHECK_THAT(accuracy_text(report),
             Catch::Contains(
                 "sampling   70 % of the set from 10 viewpoints, in 1.5 times the CPU time of the chain\n"
                 "           not even the fewest viewpoints in no more time"));
  report.outcomes.pop_back();
  CHECK_FALSE(sampling_figures(report));
  CHECK_FALSE(sampling_figures(example()));
}

TEST_CASE("along a segment the report is valid JSON by its schema") {
  const Json json = written(along_a_segment());
  CHECK(schema_violations(schema(), json) == std::vector<std::string>{});
  CHECK(json["query"]["kind"] == "segment");
  CHECK(json["area"]["measure"] == "sight");
  CHECK(json["ways"][2]["engine"] == "plain");
  CHECK(json["ways"][4]["viewpoints"] == 10);
  CHECK(json["ways"][4]["samples"].is_null());
  CHECK_FALSE(json["ways"][1].contains("engine"));
  CHECK_FALSE(written(example())["ways"][2].contains("viewpoints"));
  Json bad = json;
  bad["query"].erase("segments");
  CHECK_FALSE(schema_violations(schema(), bad).empty());
}

TEST_CASE("sight is missed by the time that a triangle is seen") {
  const std::vector<ImagePart> parts = seen_parts({{0, 3, 1.5}, {2, 1, 0.5}});
  CHECK(score({out, out, in}, {in, out, in}, parts).area_missed == 0.75);
}

TEST_CASE("of a cell all proofs together are what is known, and they may not contradict each other") {
  constexpr Status open = Status::undecided;
  const std::vector<Status> lower = {in, open, open, in}, upper = {open, out, open, in},
                            all = {in, out, open, in};
  CHECK(united({&lower, &upper}) == all);
  CHECK(united({&upper, &lower}) == all);
  const std::vector<Status> wrong = {open, open, open, out};
  CHECK_THROWS_AS(united({&lower, &wrong}), Error);
  const SetExcess e = excess(upper, all);
  CHECK(e.possible == 3);
  CHECK(e.beyond == 1);
  CHECK(e.share == 0.5);
  // What is not known to be hidden is not called wrong.
  CHECK(score({in, in, in, out}, all, {}).wrong_in == 1);
  CHECK(score({in, in, in, out}, all, {}).set_missed == 0.5);
}

TEST_CASE("of a cell the report tells bounds against time, and what sampling misses") {
  const AccuracyReport report = from_a_cell();
  const std::string text = accuracy_text(report);
  CHECK_THAT(text,
             Catch::Contains(
                 "known      by all proofs together 100 are visible, and 180 are hidden; 20 may be either"));
  CHECK_THAT(text, Catch::Contains("\nviewpoints 10 ") && Catch::Contains("\ncos 25x13 ") &&
                       Catch::Contains("130        30      30 %\n"));
  CHECK_THAT(text, Catch::Contains("1.200 times what is proven visible\n"));
  CHECK_THAT(text, Catch::EndsWith("216 viewpoints miss 5 % of what is proven visible, 5 in number\n"));
  CHECK_THAT(text, !Catch::Contains("certainty") && !Catch::Contains("area"));
  const std::string svg = drawn(report);
  CHECK_THAT(svg, Catch::Contains("grid of viewpoints") && Catch::Contains(">25x13<") &&
                      Catch::Contains("beyond") && !Catch::Contains("area missed"));
  const Json json = written(report);
  CHECK(schema_violations(schema(), json) == std::vector<std::string>{});
  CHECK(json["known"] == Json{{"visible", 100}, {"possible", 120}});
  CHECK(json["ways"][4]["excess"] == Json{{"possible", 130}, {"beyond", 30}, {"share", 0.3}});
  CHECK(json["ways"][4]["pixels"] == Json{25, 13});
  CHECK(json["ways"][4]["score"].is_null());
  CHECK(json["ways"][0]["viewpoints"] == 8);
  Json bad = json;
  bad["ways"][4]["excess"].erase("share");
  CHECK_FALSE(schema_violations(schema(), bad).empty());
  CHECK_FALSE(written(example()).contains("known"));
}

TEST_CASE("only a finer way of the same kind is held back by a coarser one") {
  const Way coarse = cell_way(CellMethod::cos, 0, {25, 13}), fine = cell_way(CellMethod::cos, 0, {50, 25});
  CHECK(refines(fine, coarse));
  CHECK(refines(cell_way(CellMethod::lower, 10), cell_way(CellMethod::lower, 1)));
  CHECK_FALSE(refines(cell_way(CellMethod::lower), cell_way(CellMethod::lower, 1000)));
  CHECK_FALSE(refines(coarse, cell_way(CellMethod::lower)));
  CHECK_FALSE(refines(cell_way(CellMethod::bounds), fine));
  CHECK(refines({Method::sampled, Arithmetic::chain, 2}, {Method::sampled, Arithmetic::chain, 1}));
  CHECK_FALSE(refines({Method::sampled, Arithmetic::chain, 1}, {Method::aggressive}));
}
