// provis export: the exact scene as PLY.

#include <CLI/CLI.hpp>

#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"

namespace provis {

namespace {

struct ExportOptions {
  SceneOptions scene;
  std::string out;
};

void run_export(const ExportOptions& options, Run& run) {
  options.scene.validate();
  const Scene scene = options.scene.load(run);
  run.stage("writing " + options.out);
  export_ply(scene, options.out);
}

}  // namespace

Action add_export(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("export", "Write the exact scene as binary float64 PLY, triangles in id order");
  const auto options = std::make_shared<ExportOptions>();
  options->scene.add_to(*command);
  command->add_option("--out", options->out, "PLY file to write; reading it back gives the same hash")
      ->required()
      ->type_name("FILE");
  command->footer("Example: provis export house.glb --out house.ply");
  return [options](Run& run) { run_export(*options, run); };
}

}  // namespace provis
