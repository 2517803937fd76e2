// provis info: what a scene holds, and what its queries will have to simulate.

#include <CLI/CLI.hpp>

#include "provis/effects.hpp"
#include "src/cli/output.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"
#include "src/report/scene_report.hpp"

namespace provis {

namespace {

struct InfoOptions {
  SceneOptions scene;
  bool json = false;
};

void run_info(const InfoOptions& options, Run& run) {
  options.scene.validate();
  const Scene scene = options.scene.load(run);
  run.stage("summarizing " + options.scene.file);
  const EffectsPlan plan = plan_effects(scene, Projection::pinhole);
  print(options.json ? scene_json(options.scene.file, scene, plan)
                     : scene_text(options.scene.file, scene, plan));
}

}  // namespace

Action add_info(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("info", "Print what a scene holds: counts, extent, flags, hash, effects");
  const auto options = std::make_shared<InfoOptions>();
  options->scene.add_to(*command);
  command->add_flag("--json", options->json, "JSON instead of text");
  command->footer("Example: provis info house.glb");
  return [options](Run& run) { run_info(*options, run); };
}

}  // namespace provis
