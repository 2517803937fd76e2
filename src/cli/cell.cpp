// provis cell: what is visible from somewhere in a box.

#include "provis/cell.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>

#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "provis/witness.hpp"
#include "src/cli/cell_method.hpp"
#include "src/cli/cell_place.hpp"
#include "src/cli/common_options.hpp"
#include "src/cli/detail_options.hpp"
#include "src/cli/option_group.hpp"
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

struct CellCommand {
  SceneOptions source;
  CellPlace place;
  WindowOptions looking;
  CellMethodOptions how;
  DetailOptions simplified;
  std::string out, ids;
  bool witness = false, stats = false;

  void add_to(CLI::App& command);
  void run(Run& run) const;

 private:
  ViewCell cell() const;
  std::uint64_t seed() const { return source.seed.empty() ? 1 : source.seed_number(); }
  ResultFile query(const Scene& scene, const ViewCell& cell, Run& run) const;
  void say(const std::string& text) const { provis::say(text, out == "-" || ids == "-"); }
};

/// All that is not proven to be hidden.
VisibleSet upper_set(VisibleSet set) {
  for (Status& s : set.status)
    if (s == Status::undecided) s = Status::visible;
  return set;
}

ViewCell CellCommand::cell() const {
  ViewCell where = place.cell();
  where.window = looking.frame(place.middle(), how.raster());
  check(where);
  return where;
}

ResultFile CellCommand::query(const Scene& scene, const ViewCell& where, Run& run) const {
  const std::optional<LoadedDetail> loaded = simplified.load(source, scene, run);
  run.stage("computing what is visible");
  ResultFile result;
  ResultHeader& h = result.header;
  source.state(scene, h);
  h.cell = where;
  h.view = center_view(where);
  how.record(h.options, seed());
  if (loaded) simplified.state(*loaded, h.options);

  ProgressLine line;
  Context context = run.context;
  if (line.enabled()) context.on_progress = [&](const Progress& progress) { line.show(progress); };
  const PeakMemory peak;
  CellSet set = how.answer(scene, where, seed(), loaded ? &loaded->detail : nullptr, context);
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
  how.validate();
  if (witness && how.method == "sampled")
    throw Error(Error::Code::usage, "--witness", "has no place with --method sampled: nothing is proven");
  run.context.threads = how.thread_count();
  const ViewCell where = cell();
  simplified.validate(how.method);
  std::optional<Output> result_file, ids_file;
  if (!out.empty()) result_file.emplace(out);
  if (!ids.empty()) ids_file.emplace(ids);

  const Scene scene = source.load(run);
  warn_of_left_out(scene, source.file);
  const ResultFile result = query(scene, where, run);

  run.stage("writing the result");
  if (result_file) write_result(result, result_file->stream());
  if (ids_file) write_ids(how.method == "cos" ? upper_set(result.set) : result.set, ids_file->stream());
  for (std::optional<Output>* f : {&result_file, &ids_file})
    if (*f) (*f)->commit();
  if (!result_file && !ids_file) print(summary(result));
  if (stats)
    say(cell_table(*result.counts) + sign_table(result.set.stats.signs) + memory_text(result.set.stats));
}

void CellCommand::add_to(CLI::App& command) {
  source.add_to(command);
  place.add_to(command);
  for (const char* option : {"--center", "--edge"}) command.get_option(option)->required();
  looking.add_to(command);
  simplified.add_to(command);
  how.add_to(command);
  const OptionGroup output(command, "Output");
  add_out(output, out);
  output("--ids", ids, "FILE",
         "Write one visible id per line, ascending, with 'cos' also the undecided ones; '-' is standard "
         "output");
  output("--stats", stats,
         "Print all counters and times of the stages, how many comparisons each tier of the arithmetic "
         "decided, and the peak of memory");
  add_witness(output, witness);
  command.footer(
      "What is called visible is seen from some point of the cell, and what is called hidden from none; what "
      "is\n"
      "undecided may be either. Only 'sampled' proves neither.\n\n"
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
