// provis cell: what is visible from somewhere in a box.

#include "provis/cell.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "provis/witness.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/detail_options.hpp"
#include "src/cli/output.hpp"
#include "src/cli/peak_memory.hpp"
#include "src/cli/progress.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"
#include "src/cli/window_options.hpp"
#include "src/report/cell_query.hpp"
#include "src/report/summary.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most_threads = 4096, most_viewpoints = 65536, most_directions = 256,
                        most_path_pixels = 1024, most_refinements = 32;

struct CellCommand {
  SceneOptions source;
  WindowOptions looking;
  DetailOptions simplified;
  std::string center, edge, method = "bounds", size = "32x32", refinements = "8", viewpoints = "32",
                            path_pixels = "16", directions = "4", threads = "0";
  std::string out, ids;
  bool witness = false, stats = false;

  void add_to(CLI::App& command);
  void run(Run& run) const;

 private:
  ViewCell cell() const;
  CellOptions options() const;
  ResultFile query(const Scene& scene, const ViewCell& cell, Run& run) const;
  void say(const std::string& text) const { provis::say(text, out == "-" || ids == "-"); }
};

/// All that is not proven to be hidden.
VisibleSet upper_set(VisibleSet set) {
  for (Status& s : set.status)
    if (s == Status::undecided) s = Status::visible;
  return set;
}

/// One length for a cube, three for a box.
ViewCell CellCommand::cell() const {
  const Vec3d middle = parse_vec3("--center", center);
  ViewCell where;
  if (edge.find(',') != std::string::npos) {
    where = cell_around(middle, parse_vec3("--edge", edge));
  } else {
    const double a = parse_number("--edge", edge);
    where = cell_around(middle, {a, a, a});
  }
  where.window = looking.frame(middle, parse_size("--cos-size", size));
  return where;
}

CellOptions CellCommand::options() const {
  const auto whole = [](const char* option, const std::string& text, std::uint64_t most) {
    return static_cast<int>(parse_whole(option, text, 0, most));
  };
  CellOptions o;
  o.method = method == "lower"       ? CellMethod::lower
             : method == "cos"       ? CellMethod::cos
             : method == "cos-exact" ? CellMethod::cos_exact
                                     : CellMethod::bounds;
  const auto [width, height] = parse_size("--cos-size", size);
  o.pixels = {width, height};
  o.refinements = whole("--refinements", refinements, most_refinements);
  o.viewpoints = whole("--viewpoints", viewpoints, most_viewpoints);
  o.path_pixels = whole("--path-pixels", path_pixels, most_path_pixels);
  o.directions = whole("--directions", directions, most_directions);
  if (!source.seed.empty()) o.seed = source.seed_number();
  return o;
}

ResultFile CellCommand::query(const Scene& scene, const ViewCell& where, Run& run) const {
  const std::optional<LoadedDetail> loaded = simplified.load(source, scene, run);
  run.stage("computing what is visible");
  ResultFile result;
  ResultHeader& h = result.header;
  source.state(scene, h);
  h.cell = where;
  h.view = center_view(where);
  h.options["method"] = method;
  h.options["cos-size"] = size;
  h.options["refinements"] = refinements;
  h.options["viewpoints"] = viewpoints;
  h.options["path-pixels"] = path_pixels;
  h.options["sample-directions"] = directions;
  h.options["viewpoint-seed"] = std::to_string(options().seed);
  if (loaded) simplified.state(*loaded, h.options);

  ProgressLine line;
  Context context = run.context;
  if (line.enabled()) context.on_progress = [&](const Progress& progress) { line.show(progress); };
  const PeakMemory peak;
  CellOptions how = options();
  if (loaded) how.detail = &loaded->detail;
  CellSet set = visible_from_cell(scene, where, how, context);
  if (witness) {
    run.stage("verifying the witnesses");
    say(fmt::format("verified   {} witnesses, each against all {} triangles\n",
                    verify_witnesses(scene, where, set, run.context), scene.triangles().size()));
  } else {
    set.set.witnesses.clear();
  }
  set.set.stats.peak_bytes = peak.bytes();
  result.set = std::move(set.set);
  result.boundary = std::move(set.boundary);
  result.counts = CellCounts{std::move(set.unwitnessed), set.bounds, set.offset, set.detail};
  return result;
}

void CellCommand::run(Run& run) const {
  SceneOptions stated = source;
  stated.seed_has_use = true;
  stated.validate();
  if (out == "-" && ids == "-")
    throw Error(Error::Code::usage, "-", "standard output can take only one of --out and --ids");
  run.context.threads = static_cast<int>(parse_whole("--threads", threads, 0, most_threads));
  const ViewCell where = cell();
  check(where);
  (void)options();
  simplified.validate(method);
  std::optional<Output> result_file, ids_file;
  if (!out.empty()) result_file.emplace(out);
  if (!ids.empty()) ids_file.emplace(ids);

  const Scene scene = source.load(run);
  warn_of_left_out(scene, source.file);
  const ResultFile result = query(scene, where, run);

  run.stage("writing the result");
  if (result_file) write_result(result, result_file->stream());
  if (ids_file) write_ids(method == "cos" ? upper_set(result.set) : result.set, ids_file->stream());
  for (std::optional<Output>* f : {&result_file, &ids_file})
    if (*f) (*f)->commit();
  if (!result_file && !ids_file) print(summary(result));
  if (stats)
    say(cell_table(*result.counts) + sign_table(result.set.stats.signs) + memory_text(result.set.stats));
}

void CellCommand::add_to(CLI::App& command) {
  source.add_to(command);
  const char* where = "The cell";
  command.add_option("--center", center, "Its middle")->required()->type_name("X,Y,Z")->group(where);
  command.add_option("--edge", edge, "The length of its edges, or one for each axis; 0 makes it flat")
      ->required()
      ->type_name("A[,B,C]")
      ->group(where);
  looking.add_to(command);
  simplified.add_to(command);
  const char* computing = "How to compute";
  command
      .add_option(
          "--method", method,
          "'bounds', what is proven visible and what is not proven hidden; 'lower', only what is proven "
          "visible; 'cos', what the camera offset space does not prove hidden; 'cos-exact', what its samples "
          "show, one direction in the centre of each pixel, exactly [bounds]")
      ->check(CLI::IsMember({"bounds", "lower", "cos", "cos-exact"}))
      ->type_name("")
      ->group(computing);
  const auto number = [&](const char* name, std::string& value, const char* help) {
    command.add_option(name, value, help)->type_name("N")->group(computing);
  };
  command
      .add_option(
          "--cos-size", size,
          "Pixels of each raster of the camera offset space, five around each face, one with --dir; at most "
          "1024 each way: more hides more, and shows more with 'cos-exact' [32x32]")
      ->type_name("WxH")
      ->group(computing);
  number("--refinements", refinements,
         "How often the rays of a pixel are halved where a triangle stays undecided, 0 to 32 [8]");
  number("--viewpoints", viewpoints,
         "Exact sets from so many viewpoints, besides corners and middle, 0 to 65536 [32]");
  number(
      "--path-pixels", path_pixels,
      "Look continuously along the cell's edges and diagonals, at N^2 pixels of each frame, for 'bounds' and "
      "'lower', 0 to 1024 [16]");
  number("--directions", directions,
         "Exact samples of the camera offset space for 'bounds' and 'lower', N^2 for each face of the cell, "
         "0 to "
         "256 [4]");
  number("--threads", threads, "Threads, 0 to 4096; 0 takes every core; never changes the answer [0]");
  const char* output = "Output";
  command
      .add_option("--out", out, "Write the result as JSON, which 'provis draw' reads; '-' is standard output")
      ->type_name("FILE")
      ->group(output);
  command
      .add_option(
          "--ids", ids,
          "Write one visible id per line, ascending, with 'cos' also the undecided ones; '-' is standard "
          "output")
      ->type_name("FILE")
      ->group(output);
  command
      .add_flag(
          "--stats", stats,
          "Print all counters and times of the stages, how many comparisons each tier of the arithmetic "
          "decided, and the peak of memory")
      ->group(output);
  command
      .add_flag("--witness", witness,
                "Add to the result a verified proof for each visible primitive: a ray that sees it")
      ->group(output);
  command.footer(
      "What is called visible is seen from some point of the cell, and what is called hidden from none; what "
      "is\n"
      "undecided may be either.\n\n"
      "Examples:\n"
      "  provis cell town.glb --center 0,1.7,0 --edge 0.3\n"
      "  provis cell town.glb --center 0,1.7,0 --edge 1,0.5,1 --cos-size 128x128 --witness --out town.json\n"
      "  provis cell town.glb --center 0,1.7,0 --edge 0.3 --dir 0,0,-1 --method cos --cos-size 200x100 "
      "--stats\n"
      "  provis cell town.glb --center 0,1.7,0 --edge 0.3 --occluders inner.glb --shell outer.glb --objects "
      "town.json");
}

}  // namespace

Action add_cell(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("cell", "Compute which primitives are visible from somewhere in a box");
  const auto options = std::make_shared<CellCommand>();
  options->add_to(*command);
  return [options](Run& run) { options->run(run); };
}

}  // namespace provis
