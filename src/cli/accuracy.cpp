// provis accuracy: what accuracy costs, one query answered in every way there is.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <limits>
#include <optional>

#include "provis/error.hpp"
#include "src/cli/accuracy_runs.hpp"
#include "src/cli/accuracy_ways.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/cell_place.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/output.hpp"
#include "src/cli/path_options.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"
#include "src/cli/view_options.hpp"
#include "src/cli/window_options.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most_threads = 4096, most_runs = 1000;

struct AccuracyCommand {
  SceneOptions source;
  ViewOptions view;
  // What these have in common with a view stands in `view`.
  PathOptions path;
  CellPlace place;
  std::string runs = "3", time_limit = "60", memory_limit, threads = "0";
  std::string json, picture;
  CLI::App* command = nullptr;

  void add_to(CLI::App& app);
  void run(Run& run) const;

 private:
  void validate() const;
  AccuracyPlan plan() const;
  bool along_segments() const { return !path.from.empty() || !path.to.empty() || !path.rect.empty(); }
  SegmentQuery segments() const;
  ViewCell cell() const;
  PixelGrid sampled_pixels() const;
  void state_query(ResultHeader& header) const;
  std::vector<std::string> query() const;
};

double parse_seconds(const std::string& option, const std::string& text) {
  const double seconds = parse_number(option, text);
  if (seconds > 0) return seconds;
  throw Error(Error::Code::usage, option, fmt::format("expected seconds above 0, got \"{}\"", text));
}

/// A whole number with a unit of 1024, 1024^2 or 1024^3 behind it, or none.
std::uint64_t parse_bytes(const std::string& option, std::string text) {
  int shift = 0;
  for (const auto& [unit, bits] : {std::pair{'K', 10}, {'M', 20}, {'G', 30}})
    if (!text.empty() && text.back() == unit) shift = bits;
  if (shift > 0) text.pop_back();
  return parse_whole(option, text, 0, std::numeric_limits<std::uint64_t>::max() >> shift) << shift;
}

/// So that a run that goes astray does not take the machine with it.
std::uint64_t half_of_memory() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 2;
}

/// The options of scene and view as they were given: a child asks the same. Of a cell, the directions are
/// stated verbatim, since a camera's window would follow from the pixels of each way.
std::vector<std::string> AccuracyCommand::query() const {
  std::vector<std::string> words = {source.file};
  for (const CLI::Option* option : command->get_options()) {
    const std::string& group = option->get_group();
    const bool asks = group == SceneOptions::group || group == CellPlace::group ||
                      (group == ViewOptions::group && !place.given());
    if (!asks || option->count() == 0) continue;
    if (option->get_type_size() == 0) {
      words.push_back(option->get_name());
    } else {
      words.push_back(option->get_name() + "=" + option->results().back());
    }
  }
  if (place.given())
    if (const std::optional<Frame> window = cell().window) {
      const auto text = [](const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); };
      const Window& w = window->window;
      words.insert(words.end(), {"--right=" + text(window->right), "--up=" + text(window->up),
                                 "--forward=" + text(window->forward),
                                 fmt::format("--window={},{},{},{}", w.x0, w.x1, w.y0, w.y1)});
    }
  return words;
}

AccuracyPlan AccuracyCommand::plan() const {
  AccuracyPlan plan;
  plan.command = place.given() ? "cell" : along_segments() ? "segment" : "point";
  plan.ways = place.given() ? cell_ways(sampled_pixels()) : along_segments() ? segment_ways() : point_ways();
  plan.query = query();
  plan.runs = static_cast<int>(parse_whole("--runs", runs, 1, most_runs));
  plan.limits.seconds = parse_seconds("--time-limit", time_limit);
  plan.limits.bytes = memory_limit.empty() ? half_of_memory() : parse_bytes("--memory-limit", memory_limit);
  plan.threads = static_cast<int>(parse_whole("--threads", threads, 0, most_threads));
  return plan;
}

void AccuracyCommand::validate() const {
  source.validate();
  const std::string ending = ".svg";
  const bool svg = picture == "-" || (picture.size() > ending.size() && picture.ends_with(ending));
  if (!picture.empty() && !svg) {
    throw Error(Error::Code::usage, "--picture",
                fmt::format("writes SVG: expected a name that ends in {}, got \"{}\"", ending, picture));
  }
  if (json == "-" && picture == "-")
    throw Error(Error::Code::usage, "--picture", "standard output can take only one of --json and --picture");
}

SegmentQuery AccuracyCommand::segments() const {
  for (const auto& [option, text] :
       {std::pair("--eye", view.eye), {"--view", view.projection}, {"--views", view.views}})
    if (!text.empty()) throw Error(Error::Code::usage, option, "has no place along a segment");
  PathOptions all = path;
  static_cast<CameraOptions&>(all) = view;
  all.size = view.size;
  return all.query(source.seed_number());
}

PixelGrid AccuracyCommand::sampled_pixels() const {
  const auto [width, height] = view.size.empty() ? std::array{800, 800} : parse_size("--size", view.size);
  return {width, height};
}

ViewCell AccuracyCommand::cell() const {
  for (const auto& [option, text] : {std::pair("--eye", view.eye),
                                     {"--view", view.projection},
                                     {"--views", view.views},
                                     {"--from", path.from},
                                     {"--to", path.to},
                                     {"--rect", path.rect},
                                     {"--faces", path.faces}})
    if (!text.empty()) throw Error(Error::Code::usage, option, "has no place with a cell");
  WindowOptions looking;
  static_cast<CameraOptions&>(looking) = view;
  ViewCell cell = place.cell();
  const PixelGrid pixels = sampled_pixels();
  cell.window = looking.frame(place.middle(), {pixels.width, pixels.height});
  return cell;
}

void AccuracyCommand::state_query(ResultHeader& header) const {
  if (place.given()) {
    header.cell = cell();
    header.view = center_view(*header.cell);
    header.options["size"] = fmt::format("{}x{}", sampled_pixels().width, sampled_pixels().height);
    return;
  }
  if (along_segments()) {
    header.segments = segments();
    header.view = header.segments->first_view();
    return;
  }
  if (!path.faces.empty()) throw Error(Error::Code::usage, "--faces", "goes with --from and --to, or --rect");
  header.view = view.view(source.file);
  const PixelGrid usual;
  const std::array<int, 2> pixels =
      view.size.empty() ? std::array{usual.width, usual.height} : parse_size("--size", view.size);
  header.options["size"] = fmt::format("{}x{}", pixels[0], pixels[1]);
}

void AccuracyCommand::run(Run& run) const {
  validate();
  const AccuracyPlan what = plan();
  ResultHeader header;
  state_query(header);
  std::optional<Output> json_output, picture_output;
  if (!json.empty()) json_output.emplace(json);
  if (!picture.empty()) picture_output.emplace(picture);

  const Scene scene = source.load(run);
  warn_of_left_out(scene, source.file);
  source.state(scene, header);
  const AccuracyReport report = run_accuracy(what, header, scene, run);

  run.stage("writing the report");
  if (json_output) write_accuracy_json(report, json_output->stream());
  if (picture_output) write_accuracy_picture(report, picture_output->stream());
  if (json_output) json_output->commit();
  if (picture_output) picture_output->commit();
  if (json != "-" && picture != "-") print(accuracy_text(report));
}

void AccuracyCommand::add_to(CLI::App& app) {
  command = &app;
  source.add_to(app);
  view.add_to(app);
  path.add_paths_to(app);
  place.add_to(app);
  const OptionGroup how(app, "How to compute");
  how("--runs", runs, "N",
      "How often each way is run, 1 to 1000; the median counts, and least and most are told [3]");
  how("--time-limit", time_limit, "S",
      "Seconds that one run may take, loading included; then it is ended and reported as timed out [60]");
  how("--memory-limit", memory_limit, "N",
      "Bytes of data that one run may hold, or a number followed by K, M or G; 0 for no limit [half of the "
      "machine's memory]");
  how("--threads", threads, "N", "Threads of each run, 0 to 4096; 0 takes every core [0]");
  const OptionGroup output(app, "Output");
  output("--json", json, "FILE", "Write all of it as JSON; '-' is standard output, instead of the table");
  output("--picture", picture, "FILE.svg",
         "Draw what is missed over the time that it takes, as SVG; '-' is standard output, instead of the "
         "table");
  app.footer(
      "The ways from a point: doubles, chain, mpfr and exact arithmetic; aggressive sampling; 1, 2x2, 4x4 "
      "...\n"
      "256x256 samples in each pixel of --size. Along segments: each arithmetic with both engines; "
      "z-buffers\n"
      "from 10, 100 ... 100000 viewpoints. From a cell: z-buffers from 2^3, 4^3, 6^3 and 10^3 viewpoints;\n"
      "exact sets from 1, 10, 100 and 1000 besides corners and middle; the camera offset space at 25x13 ...\n"
      "400x200; both bounds by all stages. Each is a process of its own; one that fails ends nothing.\n\n"
      "Examples:\n"
      "  provis accuracy house.glb --eye 0,1.8,0 --dir 1,0,0 --picture accuracy.svg\n"
      "  provis accuracy house.glb --from 0,1.8,0 --to 4,1.8,0 --size 200x200 --json accuracy.json\n"
      "  provis accuracy house.glb --center 0,1.8,0 --edge 0.3 --picture accuracy.svg");
}

}  // namespace

Action add_accuracy(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("accuracy", "Measure what accuracy costs: one query, answered in every way");
  const auto options = std::make_shared<AccuracyCommand>();
  options->add_to(*command);
  return [options](Run& run) { options->run(run); };
}

}  // namespace provis
