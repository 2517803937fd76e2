// provis draw: pictures of a result.

#include "provis/draw.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>

#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/draw_epi.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"

namespace provis {

namespace {

using Size = std::array<int, 2>;

constexpr int default_width = 1280, default_height = 720;

struct DrawOptions {
  std::string scene, result, view_image, above, size;
  EpiOptions epi;
};

double length(const Vec3d& v) { return std::sqrt(dot(v, v)); }

// The window's own proportions; six square faces are laid out three by two.
Size view_size(const PointView& view) {
  if (view.frames.size() > 1) return {default_width, default_width * 2 / 3};
  const Frame& frame = view.frames.front();
  const Window& w = frame.window;
  const double aspect = (w.y1 - w.y0) * length(frame.up) / ((w.x1 - w.x0) * length(frame.right));
  return {default_width, static_cast<int>(std::lround(std::clamp(default_width * aspect, 16.0, 8192.0)))};
}

Scene matching_scene(const DrawOptions& options, const ResultHeader& header, Run& run) {
  const SceneOptions source = SceneOptions::from_recorded(options.scene, options.result, header.options);
  Scene scene = source.load(run);
  if (scene.hash() == header.scene_hash) return scene;
  throw Error(Error::Code::invalid_input, options.result,
              "is the result of another scene: its hash is " + header.scene_hash + ", that of " +
                  options.scene + " is " + scene.hash());
}

void run_draw(const DrawOptions& options, Run& run) {
  if (options.view_image.empty() && options.above.empty() && options.epi.file.empty()) {
    throw Error(Error::Code::usage, "draw", "give at least one of --view-image, --above and --epi");
  }
  options.epi.validate();
  const bool sized = !options.size.empty();
  const Size stated = sized ? parse_size("--size", options.size) : Size{default_width, default_height};
  run.stage("reading " + options.result);
  const ResultFile result = read_result(options.result);
  const PointView& view = result.header.view;
  if (!options.epi.file.empty()) options.epi.check_against(result, options.result);
  const Scene scene = matching_scene(options, result.header, run);
  if (!options.view_image.empty()) {
    run.stage("drawing " + options.view_image);
    const Size size = sized ? stated : view_size(view);
    // Of a cell, what the middle does not see is the matter.
    write_png(draw_frames(scene, result.set, view, size[0], size[1],
                          result.header.cell ? draw_statuses : draw_view),
              options.view_image);
  }
  if (!options.above.empty()) {
    run.stage("drawing " + options.above);
    write_png(draw_above(scene, result.set, view, stated[0], stated[1]), options.above);
  }
  if (!options.epi.file.empty()) {
    const int columns = result.header.segments->pixels.width;
    run.stage("drawing " + options.epi.file);
    write_png(options.epi.picture(scene, result, options.result,
                                  sized ? stated : Size{columns, default_height}, run.context),
              options.epi.file);
  }
}

}  // namespace

Action add_draw(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("draw", "Draw a result as PNG: the view, from above, or a row over time");
  const auto options = std::make_shared<DrawOptions>();
  command
      ->add_option("SCENE", options->scene,
                   "The scene file that was asked about; how it was loaded stands in the result")
      ->required()
      ->type_name("FILE");
  command
      ->add_option("RESULT", options->result,
                   "JSON file written with --out; of segments the first viewpoint is drawn")
      ->required()
      ->type_name("FILE");
  command
      ->add_option(
          "--view-image", options->view_image,
          "PNG to write: the view, a colour per visible primitive; an omni view as six square "
          "faces, three by "
          "two. Of a cell: from its middle, visible in orange, hidden as a grey-blue wash, undecided in "
          "green over both")
      ->type_name("FILE");
  command
      ->add_option(
          "--above", options->above,
          "PNG to write: the scene from above, visible in orange, hidden as a grey-blue wash, undecided in "
          "green, the viewpoint and its window in blue")
      ->type_name("FILE");
  command
      ->add_option("--size", options->size,
                   "Pixels of each picture, 1 to 16384 each way [the view: 1280 wide, as high as its "
                   "window's proportions "
                   "ask for; from above: 1280x720; over time: a column for each pixel, 720 high]")
      ->type_name("WxH");
  options->epi.add_to(*command);
  command->footer(
      "Examples:\n"
      "  provis draw house.glb house.json --view-image view.png --above above.png\n"
      "  provis draw house.glb walk.json --epi epi.png --row 400 --face 5");
  return [options](Run& run) { run_draw(*options, run); };
}

}  // namespace provis
