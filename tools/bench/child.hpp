#pragma once
// What the measured programs share: their options, the scene and the view, clocks, memory, one line of JSON.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"

namespace provis::bench {

/// The pixels of everything that has pixels.
constexpr int width = 1280, height = 720;

/// One measured program. Loads the scene once, with every surface opaque and two-sided as in the papers, so
/// that all programs answer one question.
class Child {
 public:
  explicit Child(const std::string& name);

  CLI::App& options() { return app_; }

  /// Reads the options, loads, calls the work, prints what it returns as one line of JSON. The exit status.
  int run(int argc, char** argv, const std::function<nlohmann::json(const Child&)>& work);

  const Scene& scene() const { return scene_; }
  const PointView& view() const { return view_; }
  Context context() const;
  int threads() const { return threads_; }
  double budget() const { return budget_; }

  /// Runs the work up to --runs times, as long as less than --budget CPU seconds have passed: seconds of each
  /// run and the memory that they needed beyond what was there before.
  nlohmann::json measured(const std::function<void()>& work) const;

  /// How many ids were found, and, where there is a --reference, which part of it, and how many others.
  nlohmann::json found(const std::vector<PrimitiveId>& ids) const;

 private:
  void load();

  CLI::App app_;
  std::string scene_file_, view_name_, reference_file_;
  int runs_ = 5, threads_ = 1;
  double budget_ = 300;
  Scene scene_;
  PointView view_;
};

/// The ids whose flag is set, ascending.
std::vector<PrimitiveId> flagged(const std::vector<std::uint8_t>& flags);

/// Ids as little-endian 32-bit numbers: how one child tells the others what the exact set is.
void write_reference(const std::vector<PrimitiveId>& ids, const std::string& file);

}  // namespace provis::bench
