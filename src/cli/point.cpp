// provis point: what is visible from a point.

#include "provis/point.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "provis/check_doubles.hpp"
#include "provis/effects.hpp"
#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "provis/witness.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/common_options.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/output.hpp"
#include "src/cli/peak_memory.hpp"
#include "src/cli/progress.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"
#include "src/cli/view_options.hpp"
#include "src/report/names.hpp"
#include "src/report/scene_report.hpp"
#include "src/report/summary.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most_threads = 4096, most_samples = 256;

struct PointCommand {
  SceneOptions source;
  ViewOptions view;
  std::string method = "exact", engine = "fast", samples, arithmetic = "chain", threads = "0";
  std::string out, ids;
  bool witness = false, subdivision = false, effects = false, stats = false, check = false;

  void add_to(CLI::App& command);
  void run(Run& run) const;

 private:
  PointOptions point_options(const PointView& where) const;
  void record(const PointOptions& options, std::map<std::string, std::string>& header) const;
  ResultFile query(const Scene& scene, const PointView& where, Run& run) const;
  bool result_on_stdout() const { return out == "-" || ids == "-"; }
  void say(const std::string& text) const { provis::say(text, result_on_stdout()); }
};

PointOptions PointCommand::point_options(const PointView& where) const {
  PointOptions options;
  options.arithmetic = arithmetic_named(arithmetic).value();
  options.method = method_named(method).value();
  options.engine = engine_named(engine).value();
  options.witnesses = witness;
  options.subdivision = subdivision;
  if (!samples.empty() && options.method != Method::sampled)
    throw Error(Error::Code::usage, "--samples", "goes with --method sampled only");
  if (engine != "fast" && options.method != Method::exact)
    throw Error(Error::Code::usage, "--engine", "goes with --method exact only");
  if (!samples.empty())
    options.samples = static_cast<int>(parse_whole("--samples", samples, 1, most_samples));
  if (where.projection == Projection::omni) options.pixels = {1024, 1024};
  if (!view.size.empty()) {
    const auto [width, height] = parse_size("--size", view.size);
    options.pixels = {width, height};
  }
  return options;
}

/// Only what can change the set, beside the method: the pixels of an exact set cannot.
void PointCommand::record(const PointOptions& options, std::map<std::string, std::string>& header) const {
  header["method"] = method;
  header["arithmetic"] = arithmetic;
  if (options.engine != PointEngine::fast) header["engine"] = engine;
  if (options.method == Method::exact) return;
  header["size"] = fmt::format("{}x{}", options.pixels.width, options.pixels.height);
  if (options.method == Method::sampled) header["samples"] = fmt::format("{}", options.samples);
}

ResultFile PointCommand::query(const Scene& scene, const PointView& where, Run& run) const {
  const PointOptions options = point_options(where);

  ResultFile result;
  ResultHeader& header = result.header;
  source.state(scene, header);
  header.view = where;
  record(options, header.options);

  ProgressLine line;
  Context context = run.context;
  if (line.enabled()) context.on_progress = [&](const Progress& progress) { line.show(progress); };
  const PeakMemory memory;
  result.set =
      check ? check_doubles(scene, where, context) : visible_from_point(scene, where, options, context);
  result.set.stats.peak_bytes = memory.bytes();
  if (witness) {
    run.stage("verifying the witnesses");
    const std::size_t held = verify_witnesses(scene, where, result.set, context);
    say(fmt::format("verified   {} witnesses, each against all {} triangles\n", held, header.triangles));
  }
  return result;
}

void PointCommand::run(Run& run) const {
  source.validate();
  if (out == "-" && ids == "-") {
    throw Error(Error::Code::usage, "--ids", "standard output can take only one of --out and --ids");
  }
  if (check && (arithmetic != "doubles" || method != "exact" || engine != "fast" || witness || subdivision)) {
    throw Error(Error::Code::usage, "--check",
                "goes with --arithmetic doubles and without --method, --engine, --witness and --subdivision");
  }
  run.context.threads = static_cast<int>(parse_whole("--threads", threads, 0, most_threads));
  const PointView where = view.view(source.file);
  std::optional<Output> result_output, ids_output;
  if (!out.empty()) result_output.emplace(out);
  if (!ids.empty()) ids_output.emplace(ids);

  const Scene loaded = source.load(run);
  warn_of_left_out(loaded, source.file);
  if (effects) say(effects_text(plan_effects(loaded, where.projection)));
  run.stage("computing what is visible");
  const ResultFile result = query(loaded, where, run);

  run.stage("writing the result");
  if (result_output) write_result(result, result_output->stream());
  if (ids_output) write_ids(result.set, ids_output->stream());
  if (result_output) result_output->commit();
  if (ids_output) ids_output->commit();
  if (!result_output && !ids_output) print(summary(result));
  if (stats)
    say(sampling_text(result.set.stats) + sign_table(result.set.stats.signs) + memory_text(result.set.stats));
}

void PointCommand::add_to(CLI::App& command) {
  source.add_to(command);
  view.add_to(command);
  const OptionGroup computing(command, "How to compute");
  computing("--method", method, {"exact", "aggressive", "sampled"},
            "How the set is found: 'exact' decides every primitive; 'aggressive' finds, and proves, every "
            "one that a pixel of --size shows a whole part of; 'sampled' looks along a regular grid of "
            "rays and proves what it finds [exact]");
  computing("--samples", samples, "N",
            "With --method sampled: N x N rays in each pixel of --size, 1 to 256 [1]");
  computing("--engine", engine, {"fast", "paper"},
            "With --method exact: 'fast', or 'paper', the algorithm of Popescu et al., which gives the "
            "same set and counts how it came to it [fast]");
  add_arithmetic(computing, arithmetic, check);
  add_threads(computing, threads);
  const OptionGroup output(command, "Output");
  add_out(output, out);
  add_ids(output, ids);
  add_witness(output, witness);
  output("--subdivision", subdivision,
         "Add to the result the pieces of the window in which one set of primitives is seen, with their "
         "exact areas");
  add_effects(output, effects);
  output("--stats", stats,
         "Print how many comparisons each tier of the arithmetic decided, the counters of the method, "
         "and the peak of memory");
  command.footer(
      "Without --out or --ids a summary of about ten lines goes to standard output.\n\n"
      "Examples:\n"
      "  provis point house.glb --eye 0,1.8,0 --dir 1,0,0\n"
      "  provis point house.glb --eye 0,1.8,0 --view omni --out house.json --ids house.ids\n"
      "  provis point house.glb --views views.json:entrance --out house.json");
}

}  // namespace

Action add_point(CLI::App& program) {
  CLI::App* command = program.add_subcommand("point", "Compute which primitives are visible from a point");
  const auto options = std::make_shared<PointCommand>();
  options->add_to(*command);
  return [options](Run& run) { options->run(run); };
}

}  // namespace provis
