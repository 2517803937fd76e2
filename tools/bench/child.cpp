#include "tools/bench/child.hpp"

#include <malloc.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>

#include "provis/error.hpp"
#include "src/cli/views_file.hpp"

namespace provis::bench {

namespace {

double cpu_clock() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double wall_clock() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A line of /proc/self/status in bytes: VmRSS is what the process has now, VmHWM the most it had.
std::int64_t memory(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key + ":")) return std::stoll(line.substr(key.size() + 1)) * 1024;
  throw Error(Error::Code::internal, "/proc/self/status", "has no " + key);
}

/// What was loaded and freed goes back to the system, and the highest mark starts from here.
std::int64_t start_of_memory() {
  malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << "5";
  return memory("VmRSS");
}

std::vector<PrimitiveId> read_reference(const std::string& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  std::vector<PrimitiveId> ids(static_cast<std::size_t>(in.tellg()) / sizeof(PrimitiveId));
  in.seekg(0).read(reinterpret_cast<char*>(ids.data()),
                   static_cast<std::streamsize>(ids.size() * sizeof(PrimitiveId)));
  if (!in) throw Error(Error::Code::invalid_input, file, "cannot be read");
  return ids;
}

}  // namespace

Child::Child(const std::string& name) : app_("Part of tools/bench/run: measures one configuration.", name) {
  app_.add_option("scene", scene_file_, "Scene file")->required();
  app_.add_option("view", view_name_, "FILE:NAME of a view")->required();
  app_.add_option("--runs", runs_, "How often [5]");
  app_.add_option("--budget", budget_, "CPU seconds after which no further run begins [300]");
  app_.add_option("--threads", threads_, "Threads [1]");
  app_.add_option("--reference", reference_file_, "Ids of the exact set");
}

int Child::run(int argc, char** argv, const std::function<nlohmann::json(const Child&)>& work) try {
  CLI11_PARSE(app_, argc, argv);
  load();
  nlohmann::json result = work(*this);
  result["triangles"] = scene_.triangles().size();
  result["scene_bytes"] = array_bytes(scene_);
  std::cout << result.dump() << std::endl;
  return 0;
} catch (const Error& error) {
  std::cerr << app_.get_name() << ": error: " << error.what() << "\n";
  return exit_status(error.code());
} catch (const std::exception& error) {
  std::cerr << app_.get_name() << ": error: " << error.what() << "\n";
  return exit_status(Error::Code::internal);
}

void Child::load() {
  const std::size_t colon = view_name_.rfind(':');
  if (colon == std::string::npos) throw Error(Error::Code::usage, view_name_, "is not FILE:NAME");
  ViewRequest request =
      read_named_view(view_name_.substr(0, colon), view_name_.substr(colon + 1), scene_file_);
  request.size = {width, height};
  view_ = build_view(request, "");
  if (view_.projection != Projection::pinhole)
    throw Error(Error::Code::usage, view_name_, "is not a pinhole view");
  LoadOptions options;
  options.sides = Sides::both;
  options.opacity = Opacity::all;
  scene_ = load_scene(scene_file_, options);
}

Context Child::context() const {
  Context context;
  context.threads = threads_;
  return context;
}

nlohmann::json Child::measured(const std::function<void()>& work) const {
  const std::int64_t before = start_of_memory();
  std::vector<double> cpu, wall;
  const double began = cpu_clock();
  for (int k = 0; k < runs_ && (k == 0 || cpu_clock() - began < budget_); ++k) {
    const double cpu_before = cpu_clock(), wall_before = wall_clock();
    work();
    cpu.push_back(cpu_clock() - cpu_before);
    wall.push_back(wall_clock() - wall_before);
  }
  const std::int64_t peak = memory("VmHWM");
  return {{"cpu", cpu},
          {"wall", wall},
          {"peak_bytes", peak},
          {"extra_bytes", std::max<std::int64_t>(0, peak - before)}};
}

nlohmann::json Child::found(const std::vector<PrimitiveId>& ids) const {
  nlohmann::json counts = {{"visible", ids.size()}};
  if (reference_file_.empty()) return counts;
  const std::vector<PrimitiveId> exact = read_reference(reference_file_);
  std::vector<PrimitiveId> common;
  std::ranges::set_intersection(ids, exact, std::back_inserter(common));
  counts["share"] =
      exact.empty() ? 1.0 : static_cast<double>(common.size()) / static_cast<double>(exact.size());
  counts["wrong"] = ids.size() - common.size();
  return counts;
}

std::vector<PrimitiveId> flagged(const std::vector<std::uint8_t>& flags) {
  std::vector<PrimitiveId> ids;
  for (std::size_t t = 0; t < flags.size(); ++t)
    if (flags[t] != 0) ids.push_back(static_cast<PrimitiveId>(t));
  return ids;
}

void write_reference(const std::vector<PrimitiveId>& ids, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  out.write(reinterpret_cast<const char*>(ids.data()),
            static_cast<std::streamsize>(ids.size() * sizeof(PrimitiveId)));
  if (!out.flush()) throw Error(Error::Code::output, file, "cannot be written");
}

}  // namespace provis::bench
