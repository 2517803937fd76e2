// provis segment: what is visible along a segment, at the centres of the pixels.

#include "provis/segment.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <tuple>

#include "provis/effects.hpp"
#include "provis/error.hpp"
#include "provis/result_file.hpp"
#include "provis/witness.hpp"
#include "src/cli/common_options.hpp"
#include "src/cli/option_group.hpp"
#include "src/cli/output.hpp"
#include "src/cli/path_options.hpp"
#include "src/cli/peak_memory.hpp"
#include "src/cli/progress.hpp"
#include "src/cli/run.hpp"
#include "src/cli/scene_options.hpp"
#include "src/cli/segment_method.hpp"
#include "src/report/names.hpp"
#include "src/report/scene_report.hpp"
#include "src/report/sights.hpp"
#include "src/report/summary.hpp"
#include "src/segment/unite.hpp"

namespace provis {

namespace {

struct SegmentCommand {
  SceneOptions source;
  PathOptions path;
  SegmentMethod method;
  std::string granularity = "triangle";
  std::string out, ids, intervals, rank;
  bool witness = false, effects = false, stats = false;

  void add_to(CLI::App& command);
  void run(Run& run) const;

 private:
  ResultHeader header(const Scene& scene, const SegmentQuery& query) const;
  ResultFile query(const Scene& scene, const SegmentQuery& query, std::ostream* lists, Run& run) const;
  void require_one_standard_output() const;
  std::vector<std::string> asked_of_exact() const;
  void say(const std::string& text) const { provis::say(text, to_standard_output() > 0); }
  std::ptrdiff_t to_standard_output() const;
  std::vector<std::string> outputs() const { return {out, ids, intervals, rank}; }
};

std::ptrdiff_t SegmentCommand::to_standard_output() const {
  const std::vector<std::string> all = outputs();
  return std::count(all.begin(), all.end(), "-");
}

void SegmentCommand::require_one_standard_output() const {
  if (to_standard_output() > 1)
    throw Error(Error::Code::usage, "-",
                "standard output can take only one of --out, --ids, --intervals and --rank");
}

ResultHeader SegmentCommand::header(const Scene& scene, const SegmentQuery& query) const {
  ResultHeader h;
  source.state(scene, h);
  h.segments = query;
  h.view = query.first_view();
  method.record(h.options);
  return h;
}

/// What single viewpoints do not give.
std::vector<std::string> SegmentCommand::asked_of_exact() const {
  std::vector<std::string> asked;
  if (witness) asked.emplace_back("--witness");
  if (!intervals.empty()) asked.emplace_back("--intervals");
  if (!rank.empty()) asked.emplace_back("--rank");
  return asked;
}

ResultFile SegmentCommand::query(const Scene& scene, const SegmentQuery& where, std::ostream* lists,
                                 Run& run) const {
  ResultFile result;
  result.header = header(scene, where);
  SegmentOptions options;
  options.witnesses = witness;

  SegmentSet all;
  ProgressLine line;
  Context context = run.context;
  const PeakMemory peak;
  for (std::size_t k = 0; k < where.paths.size(); ++k) {
    const auto paths = static_cast<double>(where.paths.size());
    if (line.enabled())
      context.on_progress = [&](const Progress& p) {
        line.show({(static_cast<double>(k) + p.done / p.total) / paths, 1});
      };
    if (lists != nullptr) options.on_pixel = [&](const PixelSights& p) { write_sights(p, k, *lists); };
    SegmentSet part = method.answer(scene, where.view(k), options, context);
    if (witness) {
      run.stage("verifying the witnesses");
      const std::size_t held = verify_witnesses(scene, where.view(k), part, context);
      say(fmt::format("verified   {} witnesses, each against all {} triangles\n", held,
                      scene.triangles().size()));
      run.stage("computing what is visible");
    }
    unite(all, std::move(part));
  }
  result.set = std::move(all.set);
  result.boundary = std::move(all.boundary);
  result.seen = std::move(all.seen);
  result.set.stats.peak_bytes = peak.bytes();
  return result;
}

/// Those that are seen longest in most pixels first.
void write_rank(std::vector<Seen> seen, std::ostream& out) {
  std::sort(seen.begin(), seen.end(), [](const Seen& a, const Seen& b) {
    return std::tuple(-a.length, a.primitive) < std::tuple(-b.length, b.primitive);
  });
  for (const Seen& s : seen) out << fmt::format("{} {} {}\n", s.primitive, s.pixels, s.length);
}

/// All ids of objects that have a visible one: an object is one instance of a node's mesh.
VisibleSet whole_objects(const Scene& scene, const VisibleSet& set) {
  using Key = std::tuple<std::int32_t, std::int32_t, std::int32_t>;
  const auto key = [](const SourceRange& r) { return Key(r.node, r.mesh, r.instance); };
  std::vector<Key> seen;
  for (const SourceRange& r : scene.sources()) {
    const auto first = set.status.begin() + static_cast<std::ptrdiff_t>(r.first);
    if (std::find(first, first + r.count, Status::visible) != first + r.count) seen.push_back(key(r));
  }
  std::sort(seen.begin(), seen.end());
  VisibleSet whole = set;
  for (const SourceRange& r : scene.sources())
    if (std::binary_search(seen.begin(), seen.end(), key(r)))
      std::fill_n(whole.status.begin() + static_cast<std::ptrdiff_t>(r.first), r.count, Status::visible);
  return whole;
}

void SegmentCommand::run(Run& run) const {
  SceneOptions stated = source;
  stated.seed_has_use = !path.runs.empty();
  stated.validate();
  require_one_standard_output();
  method.validate(asked_of_exact());
  if (granularity == "object" && ids.empty())
    throw Error(Error::Code::usage, "--granularity", "says which ids --ids writes: give it too");
  run.context.threads = method.thread_count();
  const SegmentQuery where = path.query(source.seed_number());
  std::array<std::optional<Output>, 4> files;
  for (std::size_t k = 0; k < files.size(); ++k)
    if (!outputs()[k].empty()) files[k].emplace(outputs()[k]);
  auto& [result_file, ids_file, lists_file, rank_file] = files;

  const Scene scene = source.load(run);
  warn_of_left_out(scene, source.file);
  if (effects) say(effects_text(plan_effects(scene, Projection::pinhole)));
  if (granularity == "object" && scene.sources().empty())
    throw Error(Error::Code::usage, "--granularity",
                "the scene does not say which objects its triangles belong to");
  run.stage("computing what is visible");
  const ResultFile result = query(scene, where, lists_file ? &lists_file->stream() : nullptr, run);

  run.stage("writing the result");
  if (result_file) write_result(result, result_file->stream());
  if (ids_file)
    write_ids(granularity == "object" ? whole_objects(scene, result.set) : result.set, ids_file->stream());
  if (rank_file) write_rank(result.seen, rank_file->stream());
  for (std::optional<Output>& f : files)
    if (f) f->commit();
  if (!result_file && !ids_file && !rank_file && !lists_file) print(summary(result));
  if (stats) say(sign_table(result.set.stats.signs) + memory_text(result.set.stats));
}

void SegmentCommand::add_to(CLI::App& command) {
  source.add_to(command);
  path.add_to(command);
  method.add_to(command);
  const OptionGroup output(command, "Output");
  add_out(output, out);
  add_ids(output, ids);
  output("--granularity", granularity, {"triangle", "object"},
         "What --ids writes: 'triangle', the visible ones; 'object', all ids of every instance of a node's "
         "mesh that has a visible one [triangle]");
  output("--rank", rank, "FILE",
         "Write 'id pixels length' for each visible id, most important first: length is the visible share "
         "of the segment, summed over pixels");
  output("--intervals", intervals, "FILE",
         "Write what each pixel's centre shows and from when to when, a line of JSON per pixel; times are "
         "exact fractions of the segment. Long");
  output("--witness", witness,
         "Add to the result a verified proof for each visible primitive that is not at the boundary: a ray "
         "that sees it");
  add_effects(output, effects);
  output("--stats", stats,
         "Print how many comparisons each tier of the arithmetic decided, and the peak of memory");
  command.footer(
      "The answer is exact at the centres of the pixels; between them a triangle may be missed, which --size "
      "and "
      "--runs make rarer.\n"
      "Without --out, --ids, --rank or --intervals a summary of about ten lines goes to standard output.\n\n"
      "Examples:\n"
      "  provis segment town.glb --from 0,1.7,0 --to 20,1.7,0\n"
      "  provis segment town.glb --rect 0,1.7,0:23,0,0:0,0,17 --runs 4 --ids town.ids --rank town.rank\n"
      "  provis segment town.glb --from 0,1.7,0 --to 5,1.7,0 --dir 0,0,-1 --size 320x240 --witness --out "
      "town.json");
}

}  // namespace

Action add_segment(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("segment", "Compute what is visible along a segment, at pixel centres");
  const auto options = std::make_shared<SegmentCommand>();
  options->add_to(*command);
  return [options](Run& run) { options->run(run); };
}

}  // namespace provis
