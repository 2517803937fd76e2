#include "src/cli/accuracy_runs.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "provis/error.hpp"
#include "src/cli/accuracy_ways.hpp"
#include "src/cli/progress.hpp"
#include "src/cli/run.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

/// A folder that goes with the object.
class Scratch {
 public:
  Scratch() {
    std::string name = (std::filesystem::temp_directory_path() / "provis-accuracy-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw Error(Error::Code::output, name, "cannot be made");
    path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string file() const { return (path_ / "result.json").string(); }

 private:
  std::filesystem::path path_;
};

/// One child's end, and its result if that is `done`.
struct Answer {
  Ending ending = Ending::failed;
  std::string reason;
  ResultFile result;

  std::string ended() const { return std::string(name(ending)) + (reason.empty() ? "" : ": " + reason); }
};

/// A way with what its runs have given so far.
struct Tally {
  WayOutcome outcome;
  std::vector<Status> status;
  std::vector<Seen> seen;
  std::vector<double> cpu, wall, peak;
};

class Runner {
 public:
  Runner(const AccuracyPlan& plan, const ResultHeader& header, const Scene& scene, Run& run)
      : plan_(plan), scene_(scene), run_(run) {
    for (const Way& way : plan.ways) tallies_.emplace_back().outcome.way = way;
    report_.header = header;
    report_.runs = plan.runs;
    report_.time_limit = plan.limits.seconds;
    report_.memory_limit = plan.limits.bytes;
    progress_.total = static_cast<double>(tallies_.size()) * plan.runs + (header.cell       ? 0
                                                                          : header.segments ? 1
                                                                                            : 2);
  }

  AccuracyReport report();

 private:
  void measure(std::size_t index, int round);
  bool held_back(std::size_t index);
  void check_doubles();
  void compare_with_exact();
  void compare_with_known();
  std::vector<ImagePart> parts(const Tally& exact);
  Answer ask(const std::string& what, const std::vector<std::string>& options);
  Answer read_answer() const;
  Tally& of_doubles();

  const AccuracyPlan& plan_;
  const Scene& scene_;
  Run& run_;
  AccuracyReport report_;
  std::vector<Tally> tallies_;
  Scratch scratch_;
  ProgressLine line_;
  Progress progress_;
};

Ending ending_of(const ChildEnd& end) {
  if (end.timed_out) return Ending::timed_out;
  if (end.out_of_memory) return Ending::out_of_memory;
  if (end.signal != 0) return Ending::crashed;
  if (end.status == 0) return Ending::done;
  const bool refused =
      end.status == exit_status(Error::Code::usage) || end.status == exit_status(Error::Code::unsupported);
  return refused ? Ending::unavailable : Ending::failed;
}

std::string reason_of(const ChildEnd& end) {
  if (end.timed_out || end.out_of_memory) return "";
  if (end.signal != 0) return fmt::format("signal {}, {}", end.signal, strsignal(end.signal));
  if (end.complaint.empty()) return fmt::format("exit status {}", end.status);
  return end.complaint;
}

AccuracyReport Runner::report() {
  // Round by round, so that what else the machine does strikes all ways alike.
  for (int round = 0; round < plan_.runs; ++round)
    for (std::size_t k = 0; k < tallies_.size(); ++k) measure(k, round);
  for (Tally& tally : tallies_) {
    if (tally.outcome.ending != Ending::done) continue;
    tally.outcome.cpu_seconds = spread(tally.cpu);
    tally.outcome.wall_seconds = spread(tally.wall);
    tally.outcome.peak_bytes = spread(tally.peak);
  }
  if (report_.header.cell) {
    compare_with_known();
  } else {
    check_doubles();
    compare_with_exact();
  }
  for (Tally& tally : tallies_) report_.outcomes.push_back(std::move(tally.outcome));
  return std::move(report_);
}

void Runner::measure(std::size_t index, int round) {
  Tally& tally = tallies_[index];
  WayOutcome& outcome = tally.outcome;
  if ((round > 0 && outcome.ending != Ending::done) || (round == 0 && held_back(index))) {
    progress_.done += 1;
    return;
  }
  Answer answer = ask(name(outcome.way), options_of(outcome.way));
  outcome.ending = answer.ending;
  outcome.reason = answer.reason;
  if (answer.ending != Ending::done) return;
  const QueryStats& stats = answer.result.set.stats;
  tally.cpu.push_back(stats.cpu_seconds);
  tally.wall.push_back(stats.seconds);
  tally.peak.push_back(static_cast<double>(stats.peak_bytes));
  if (round > 0) return;
  outcome.signs = stats.signs;
  outcome.visible = answer.result.set.with(Status::visible).size();
  tally.status = std::move(answer.result.set.status);
  tally.seen = std::move(answer.result.seen);
  report_.threads = stats.threads;
}

/// What fewer samples, viewpoints or pixels could not do is not tried with more of them.
bool Runner::held_back(std::size_t index) {
  WayOutcome& outcome = tallies_[index].outcome;
  if (index == 0) return false;
  const WayOutcome& coarser = tallies_[index - 1].outcome;
  if (!refines(outcome.way, coarser.way) || coarser.ending == Ending::done) return false;
  outcome.ending = coarser.ending == Ending::unavailable ? Ending::unavailable : Ending::not_tried;
  outcome.reason = coarser.ending == Ending::timed_out || coarser.ending == Ending::out_of_memory
                       ? fmt::format("{} {}", name(coarser.way), name(coarser.ending))
                       : coarser.reason;
  return true;
}

Tally& Runner::of_doubles() {
  return *std::find_if(tallies_.begin(), tallies_.end(), [](const Tally& tally) {
    const Way& way = tally.outcome.way;
    return way.method == Method::exact && way.arithmetic == Arithmetic::doubles && !way.plain;
  });
}

void Runner::check_doubles() {
  WayOutcome& outcome = of_doubles().outcome;
  const Answer answer = ask("doubles, checked", {"--arithmetic", "doubles", "--check"});
  if (answer.ending == Ending::done) {
    outcome.wrong_signs = 0;
    for (const std::uint64_t count : answer.result.set.stats.signs.wrong) *outcome.wrong_signs += count;
  } else {
    outcome.unchecked = answer.ended();
  }
}

void Runner::compare_with_exact() {
  const auto certain = std::find_if(tallies_.begin(), tallies_.end(), [](const Tally& tally) {
    return tally.outcome.ending == Ending::done && tally.outcome.way.certain();
  });
  if (certain == tallies_.end()) return;
  report_.reference = certain->outcome.way;
  const std::vector<ImagePart> image = parts(*certain);
  for (Tally& tally : tallies_)
    if (tally.outcome.ending == Ending::done)
      tally.outcome.score = score(tally.status, certain->status, image);
}

void Runner::compare_with_known() {
  std::vector<const std::vector<Status>*> proofs;
  for (const Tally& tally : tallies_)
    if (tally.outcome.ending == Ending::done && tally.outcome.way.cell) proofs.push_back(&tally.status);
  if (proofs.empty()) return;
  const std::vector<Status> known = united(proofs);
  const auto all = [&](Status s) {
    return static_cast<std::size_t>(std::count(known.begin(), known.end(), s));
  };
  report_.known = KnownOfCell{all(Status::visible), known.size() - all(Status::hidden)};
  for (Tally& tally : tallies_) {
    WayOutcome& o = tally.outcome;
    if (o.ending != Ending::done) continue;
    if (o.way.method == Method::sampled || o.way.proves_visible()) o.score = score(tally.status, known, {});
    if (o.way.proves_hidden()) o.excess = excess(tally.status, known);
  }
}

std::vector<ImagePart> Runner::parts(const Tally& exact) {
  if (report_.header.segments) {
    report_.area = AreaMeasure::sight;
    return seen_parts(exact.seen);
  }
  Answer answer = ask("the subdivision", {"--arithmetic", "chain", "--subdivision"});
  if (answer.ending == Ending::done) {
    report_.area = AreaMeasure::subdivision;
    return parts_of(std::move(answer.result.set.subdivision));
  }
  report_.area = AreaMeasure::projection;
  report_.no_subdivision = answer.ended();
  return projected_parts(scene_, report_.header.view, exact.status);
}

Answer Runner::ask(const std::string& what, const std::vector<std::string>& options) {
  run_.stage("measuring " + what);
  line_.show(progress_);
  std::vector<std::string> words = {plan_.command};
  words.insert(words.end(), plan_.query.begin(), plan_.query.end());
  words.insert(words.end(), options.begin(), options.end());
  words.insert(words.end(), {"--threads", std::to_string(plan_.threads), "--out", scratch_.file()});
  const ChildEnd end = run_limited_child(words, plan_.limits, run_.context.cancel);
  progress_.done += 1;
  Answer answer{ending_of(end), reason_of(end), {}};
  return answer.ending == Ending::done ? read_answer() : answer;
}

Answer Runner::read_answer() const {
  try {
    ResultFile result = read_result(scratch_.file());
    if (result.header.scene_hash != scene_.hash())
      return {Ending::failed, "the scene has changed since the first run", {}};
    return {Ending::done, "", std::move(result)};
  } catch (const Error& error) {
    return {Ending::failed, error.what(), {}};
  }
}

}  // namespace

AccuracyReport run_accuracy(const AccuracyPlan& plan, const ResultHeader& header, const Scene& scene,
                            Run& run) {
  return Runner(plan, header, scene, run).report();
}

}  // namespace provis
