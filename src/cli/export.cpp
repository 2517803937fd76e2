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
  warn_of_left_out(scene, options.scene.file);
  run.stage("writing " + options.out);
  export_ply(scene, options.out);
}

}  // namespace

Action add_export(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("export", "Write the scene as queries see it: float64 PLY, in id order");
  const auto options = std::make_shared<ExportOptions>();
  options->scene.add_to(*command);
  command
      ->add_option(
          "--out", options->out,
          "PLY file to write. Flags and options are in it: read back without options it gives the same hash")
      ->required()
      ->type_name("FILE");
  command->footer("Example: provis export house.glb --out house.ply");
  return [options](Run& run) { run_export(*options, run); };
}

}  // namespace provis
