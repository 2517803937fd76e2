// The options of loading: what is refused before a file is read, and what a result records of them.

#include "src/cli/scene_options.hpp"

#include <bit>
#include <catch2/catch.hpp>

#include "src/cli/arguments.hpp"
#include "tests/cli/child.hpp"
#include "tests/scene/files.hpp"

using namespace provis;
using namespace provis::test;

namespace {

using Recorded = std::map<std::string, std::string>;

const Recorded plain = {{"sides", "material"}, {"opacity", "material"}, {"perturb", "0"}, {"seed", "0"}};

SceneOptions back(const Recorded& options) { return SceneOptions::from_recorded("s.ply", "r.json", options); }

Recorded with(const std::string& name, const std::string& value) {
  Recorded options = plain;
  options[name] = value;
  return options;
}

}  // namespace

TEST_CASE("only what was given is recorded of the newer options") {
  CHECK(SceneOptions{}.recorded() == plain);
  SceneOptions options;
  options.scene = "03";
  options.time = "1e-1";
  options.animation = "walk \"fast\"";
  options.radius = "+2.50";
  options.skip_invalid = true;
  Recorded expected = plain;
  expected.insert({{"scene", "3"},
                   {"time", "0.1"},
                   {"animation", "walk \"fast\""},
                   {"radius", "2.5"},
                   {"skip_invalid", "true"}});
  CHECK(options.recorded() == expected);
  CHECK(back(expected).recorded() == expected);
  CHECK(back(plain).recorded() == plain);
}

TEST_CASE("recorded numbers read back bit for bit") {
  for (const char* text : {"0.1", "1e22", "5e-324", "1.7976931348623157e308", "0.30000000000000004",
                           "123456789.125", "2.2250738585072011e-308"}) {
    SceneOptions options;
    options.time = std::string("-") + text;
    options.radius = text;
    options.perturb = text;
    const Recorded again = back(options.recorded()).recorded();
    const auto bits = [](const std::string& number) {
      return std::bit_cast<std::uint64_t>(parse_number("", number));
    };
    CHECK(bits(again.at("time")) == bits(options.time));
    CHECK(bits(again.at("radius")) == bits(text));
    CHECK(bits(again.at("perturb")) == bits(text));
  }
  SceneOptions zero;
  zero.time = "-0";
  CHECK(zero.recorded().at("time") == "-0");
}

TEST_CASE("what a result cannot have recorded is refused as its fault") {
  for (const Recorded& options :
       {with("time", "soon"), with("radius", "0"), with("scene", "-1"), with("animation", "walk"),
        with("skip_invalid", "false"), with("sides", "front"), with("perturb", "-1"), Recorded{}}) {
    const Failure failure = failure_of([&] { back(options); });
    CHECK(failure.status == 2);
    CHECK_THAT(failure.message, Catch::Contains("r.json"));
  }
}

TEST_CASE("options that make no sense are refused before the scene is read") {
  const std::vector<std::vector<std::string>> mistakes = {{"--scene", "-1"},
                                                          {"--scene", "one"},
                                                          {"--scene", "4294967296"},
                                                          {"--time", "nan"},
                                                          {"--time", "inf"},
                                                          {"--time", "later"},
                                                          {"--animation", "walk"},
                                                          {"--radius", "0"},
                                                          {"--radius", "-2"},
                                                          {"--radius", "inf"},
                                                          {"--time", ""},
                                                          {"--animation", ""},
                                                          {"--seed", "1"},
                                                          {"--radius", "1e999"},
                                                          {"--source", "-1"},
                                                          {"--source", "4294967295"},
                                                          {"--source", "first"},
                                                          {"--ids-of", ""}};
  for (const auto& words : mistakes) {
    std::vector<std::string> all = {"info", "no-such-file.ply"};
    all.insert(all.end(), words.begin(), words.end());
    const Outcome outcome = provis_run(all);
    CAPTURE(words[0], words[1]);
    CHECK(outcome.status == 1);
    CHECK_THAT(outcome.err, Catch::Contains(words[0]));
  }
  CHECK(provis_run({"info", "no-such-file.ply", "--source", "1", "--ids-of", "2"}).status == 1);
  CHECK(provis_run({"info", "no-such-file.ply", "--time", "-1.5", "--animation", "walk"}).status == 2);
}
