#include "src/cli/scene_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <limits>

#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/run.hpp"
#include "src/report/names.hpp"

namespace provis {

void SceneOptions::add_to(CLI::App& command) {
  command.add_option("SCENE", file, "glTF 2.0 (.gltf, .glb) or PLY (.ply) file")
      ->required()
      ->type_name("FILE");
  command
      .add_option("--sides", sides,
                  "Sides that are seen and that occlude: 'material' follows the file's single-sided flags, "
                  "'both' treats every surface as two-sided [material]")
      ->check(CLI::IsMember({"material", "both"}))
      ->type_name("");
  command
      .add_option(
          "--opacity", opacity,
          "What occludes: 'material' lets see-through surfaces be seen without occluding, 'all' makes "
          "everything opaque [material]")
      ->check(CLI::IsMember({"material", "all"}))
      ->type_name("");
  command
      .add_option(
          "--perturb", perturb,
          "Move each coordinate by a pseudo-random number from [-D, D], in scene units; D is at least "
          "one ulp of the largest coordinate. The answer is exact for the perturbed scene [off]")
      ->type_name("D");
  command.add_option("--seed", seed, "Seed of --perturb, 0 to 2^64-1 [0]")->type_name("N");
}

double SceneOptions::delta() const {
  const double value = parse_number("--perturb", perturb);
  if (!(value > 0)) {
    throw Error(Error::Code::usage, "--perturb",
                fmt::format("expected a number above 0, got \"{}\"", perturb));
  }
  return value;
}

std::uint64_t SceneOptions::seed_number() const {
  if (seed.empty()) return 0;
  return parse_whole("--seed", seed, 0, std::numeric_limits<std::uint64_t>::max());
}

void SceneOptions::validate() const {
  if (!perturb.empty()) delta();
  seed_number();
  if (perturb.empty() && !seed.empty()) {
    throw Error(Error::Code::usage, "--seed", "has a meaning only together with --perturb");
  }
}

Scene SceneOptions::load(Run& run) const {
  run.stage("loading " + file);
  LoadOptions options;
  options.sides = sides_named(sides).value();
  options.opacity = opacity_named(opacity).value();
  Scene scene = load_scene(file, options);
  if (perturb.empty()) return scene;
  run.stage("perturbing " + file);
  return provis::perturb(scene, delta(), seed_number());
}

std::map<std::string, std::string> SceneOptions::recorded() const {
  return {{"sides", sides},
          {"opacity", opacity},
          {"perturb", perturb.empty() ? "0" : fmt::format("{}", delta())},
          {"seed", fmt::format("{}", seed_number())}};
}

SceneOptions SceneOptions::from_recorded(const std::string& scene_file, const std::string& result_file,
                                         const std::map<std::string, std::string>& options) {
  const auto value = [&](const std::string& name) {
    const auto found = options.find(name);
    if (found == options.end()) {
      throw Error(Error::Code::invalid_input, result_file, "query has no member \"" + name + "\"");
    }
    return found->second;
  };
  SceneOptions scene;
  scene.file = scene_file;
  scene.sides = value("sides");
  scene.opacity = value("opacity");
  if (value("perturb") != "0") {
    scene.perturb = value("perturb");
    scene.seed = value("seed");
  }
  if (!sides_named(scene.sides) || !opacity_named(scene.opacity)) {
    throw Error(Error::Code::invalid_input, result_file, "query has unknown sides or opacity");
  }
  try {
    scene.validate();
  } catch (const Error& error) {
    throw Error(Error::Code::invalid_input, result_file, error.what());
  }
  return scene;
}

}  // namespace provis
