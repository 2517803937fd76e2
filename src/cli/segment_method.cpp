#include "src/cli/segment_method.hpp"

#include <algorithm>

#include "provis/check_doubles.hpp"
#include "provis/error.hpp"
#include "src/cli/arguments.hpp"
#include "src/cli/common_options.hpp"
#include "src/cli/option_group.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

constexpr std::uint64_t most_threads = 4096, most_mebibytes = 1 << 30, most_viewpoints = 100'000'000;

[[noreturn]] void refuse(const std::string& option, const std::string& why) {
  throw Error(Error::Code::usage, option, why);
}

}  // namespace

void SegmentMethod::validate(const std::vector<std::string>& asked) const {
  const bool more =
      std::any_of(asked.begin(), asked.end(), [](const auto& option) { return option != "--rank"; });
  if (check && (arithmetic != "doubles" || sampled() || engine != "fast" || more))
    refuse("--check",
           "goes with --arithmetic doubles and without --method, --engine, --witness and --intervals");
  if (!sampled()) {
    if (!viewpoints.empty()) refuse("--viewpoints", "goes with --method sampled only");
    return;
  }
  if (viewpoints.empty()) refuse("--method", "sampled needs --viewpoints");
  parse_whole("--viewpoints", viewpoints, 1, most_viewpoints);
  const char* only = "goes with --method exact only";
  if (!asked.empty()) refuse(asked.front(), only);
  if (engine != "fast") refuse("--engine", only);
  if (arithmetic != "chain") refuse("--arithmetic", only);
}

int SegmentMethod::thread_count() const {
  return static_cast<int>(parse_whole("--threads", threads, 0, most_threads));
}

void SegmentMethod::record(std::map<std::string, std::string>& options) const {
  if (sampled()) {
    options["method"] = method;
    options["viewpoints"] = viewpoints;
  } else {
    options["arithmetic"] = arithmetic;
  }
}

SegmentSet SegmentMethod::answer(const Scene& scene, const SegmentView& view, SegmentOptions options,
                                 const Context& context) const {
  if (check) return check_doubles(scene, view, context);
  if (sampled()) {
    const auto count = static_cast<int>(parse_whole("--viewpoints", viewpoints, 1, most_viewpoints));
    return sampled_along_segment(scene, view, count, context);
  }
  options.arithmetic = arithmetic_named(arithmetic).value();
  options.engine = engine == "plain" ? SegmentEngine::plain : SegmentEngine::fast;
  options.memory_bytes = parse_whole("--memory", memory, 0, most_mebibytes) << 20;
  return visible_from_segment(scene, view, options, context);
}

void SegmentMethod::add_to(CLI::App& command) {
  const OptionGroup add(command, "How to compute");
  add("--method", method, {"exact", "sampled"},
      "'exact': what is seen at any time; 'sampled': from --viewpoints single viewpoints, in plain float64, "
      "for comparison only [exact]");
  add("--viewpoints", viewpoints, "N",
      "With --method sampled: how many, 1 to 100000000, spread evenly along each segment");
  add("--engine", engine, {"fast", "plain"},
      "'fast', or 'plain', the algorithm of Popescu et al., which tests every triangle and gives the same "
      "sets [fast]");
  add_arithmetic(add, arithmetic, check);
  add("--memory", memory, "MIB",
      "MiB that the pixels' lists may take before a segment is cut in two, 0 for no bound; never changes the "
      "answer [0]");
  add_threads(add, threads);
}

}  // namespace provis
