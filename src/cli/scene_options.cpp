#include "src/cli/scene_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>

#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/run.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

double parse_positive(const std::string& option, const std::string& text) {
  const double value = parse_number(option, text);
  if (!(value > 0)) {
    throw Error(Error::Code::usage, option, fmt::format("expected a number above 0, got \"{}\"", text));
  }
  return value;
}

}  // namespace

void SceneOptions::add_to(CLI::App& command) {
  const OptionGroup add(command, group);
  command.add_option("SCENE", file, "glTF 2.0 (.gltf, .glb) or PLY (.ply) file")
      ->required()
      ->type_name("FILE");
  add("--sides", sides, {"material", "both"},
      "Sides that are seen and that occlude: 'material' follows the file's single-sided flags, 'both' treats "
      "every surface as two-sided [material]");
  add("--opacity", opacity, {"material", "all"},
      "What occludes: 'material' lets see-through surfaces be seen without occluding, 'all' makes everything "
      "opaque [material]");
  add("--scene", scene, "N", "Which scene of a glTF file, counted from 0 [the file's default]");
  add("--time", time, "T",
      "Pose the scene as it is at T seconds: a glTF file by one of its animations (before its begin and "
      "after "
      "its end it stands still), the spheres of a PLY file by their velocities vx, vy, vz [not animated]");
  add("--animation", animation, "N|NAME",
      "Which animation of a glTF file --time applies, by number from 0 or by name [the first]");
  add("--radius", radius, "R",
      "Take points that have no radius of their own as spheres of radius R, in scene units, above 0 [points "
      "are skipped]");
  add("--skip-invalid", skip_invalid,
      "Leave out broken primitives (an index out of range, a coordinate that is not finite, ...) and "
      "list them, instead of failing");
  add("--perturb", perturb, "D",
      "Move each coordinate by a pseudo-random number from [-D, D], in scene units; D is at least the "
      "spacing "
      "of float64 numbers at the largest coordinate. The answer is exact for the perturbed scene [off]");
  add("--seed", seed, "N", "Seed of --perturb, 0 to 2^64-1 [0]");
}

double SceneOptions::delta() const { return parse_positive("--perturb", perturb); }

std::uint64_t SceneOptions::seed_number() const {
  if (seed.empty()) return 0;
  return parse_whole("--seed", seed, 0, std::numeric_limits<std::uint64_t>::max());
}

LoadOptions SceneOptions::load_options() const {
  LoadOptions options;
  options.sides = sides_named(sides).value();
  options.opacity = opacity_named(opacity).value();
  if (!scene.empty()) {
    options.scene = static_cast<int>(parse_whole("--scene", scene, 0, std::numeric_limits<int>::max()));
  }
  if (!time.empty()) options.time = parse_number("--time", time);
  options.animation = animation;
  if (!radius.empty()) options.radius = parse_positive("--radius", radius);
  options.skip_invalid = skip_invalid;
  return options;
}

void SceneOptions::validate() const {
  load_options();
  if (!perturb.empty()) delta();
  seed_number();
  if (time.empty() && !animation.empty()) {
    throw Error(Error::Code::usage, "--animation", "has a meaning only together with --time");
  }
  if (perturb.empty() && !seed.empty() && !seed_has_use) {
    throw Error(Error::Code::usage, "--seed", "has a meaning only together with --perturb");
  }
}

Scene SceneOptions::load(Run& run) const {
  run.stage("loading " + file);
  Scene loaded = load_scene(file, load_options());
  if (perturb.empty()) return loaded;
  run.stage("perturbing " + file);
  return provis::perturb(loaded, delta(), seed_number());
}

std::map<std::string, std::string> SceneOptions::recorded() const {
  std::map<std::string, std::string> options = {
      {"sides", sides},
      {"opacity", opacity},
      {"perturb", perturb.empty() ? "0" : fmt::format("{}", delta())},
      {"seed", fmt::format("{}", seed_number())}};
  const LoadOptions load = load_options();
  if (load.scene) options["scene"] = fmt::format("{}", *load.scene);
  if (load.time) options["time"] = fmt::format("{}", *load.time);
  if (!load.animation.empty()) options["animation"] = load.animation;
  if (load.radius) options["radius"] = fmt::format("{}", *load.radius);
  if (load.skip_invalid) options["skip_invalid"] = "true";
  return options;
}

void SceneOptions::state(const Scene& loaded, ResultHeader& header) const {
  header.scene_file = file;
  header.scene_hash = loaded.hash();
  header.triangles = loaded.triangles().size();
  header.spheres = loaded.spheres().size();
  header.left_out.assign(loaded.left_out().begin(), loaded.left_out().end());
  header.options.merge(recorded());
}

SceneOptions SceneOptions::from_recorded(const std::string& scene_file, const std::string& result_file,
                                         const std::map<std::string, std::string>& options) {
  const auto fail = [&](const std::string& what) {
    throw Error(Error::Code::invalid_input, result_file, what);
  };
  const auto given = [&](const char* name) {
    const auto found = options.find(name);
    return found == options.end() ? std::string() : found->second;
  };
  const auto value = [&](const char* name) {
    if (options.count(name) == 0) fail(fmt::format("query has no member \"{}\"", name));
    return given(name);
  };
  SceneOptions recorded;
  recorded.file = scene_file;
  recorded.sides = value("sides");
  recorded.opacity = value("opacity");
  if (value("perturb") != "0") {
    recorded.perturb = value("perturb");
    recorded.seed = value("seed");
  }
  recorded.scene = given("scene");
  recorded.time = given("time");
  recorded.animation = given("animation");
  recorded.radius = given("radius");
  recorded.skip_invalid = given("skip_invalid") == "true";
  if (!sides_named(recorded.sides) || !opacity_named(recorded.opacity))
    fail("query has unknown sides or opacity");
  if (!recorded.skip_invalid && options.count("skip_invalid") != 0)
    fail("query has a skip_invalid other than \"true\"");
  try {
    recorded.validate();
  } catch (const Error& error) {
    fail(error.what());
  }
  return recorded;
}

void warn_of_left_out(const Scene& scene, const std::string& file) {
  constexpr std::size_t shown = 3;
  const auto left_out = scene.left_out();
  if (left_out.empty()) return;
  std::cerr << fmt::format("provis: warning: {}: left out {} invalid primitives\n", file, left_out.size());
  for (const LeftOut& item : left_out.first(std::min(shown, left_out.size()))) {
    std::cerr << fmt::format("provis: warning:   {}: {}\n", item.place, item.reason);
  }
  if (left_out.size() > shown) {
    std::cerr << fmt::format("provis: warning:   and {} more; a result's scene.left_out lists them all\n",
                             left_out.size() - shown);
  }
}

}  // namespace provis
