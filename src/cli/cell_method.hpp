#pragma once
// The options that say how `provis cell` finds its answer.

#include <array>
#include <map>
#include <string>

#include "provis/cell.hpp"

namespace CLI {
class App;
}

namespace provis {

struct CellMethodOptions {
  std::string method = "bounds", cos_size, refinements = "8", viewpoints = "32", path_pixels = "16",
              directions = "4", rays = "64", size, grid, threads = "0";

  void add_to(CLI::App& command);

  /// Throws Error::usage where an option makes no sense, or not with the others.
  void validate() const;

  int thread_count() const;

  /// Pixels of each raster, or frame: as wide to high as a camera without a window.
  std::array<int, 2> raster() const;

  /// What can change the set.
  void record(std::map<std::string, std::string>& options, std::uint64_t seed) const;

  /// detail: null for none.
  CellSet answer(const Scene& scene, const ViewCell& cell, std::uint64_t seed, const LevelOfDetail* detail,
                 const Context& context) const;

 private:
  bool sampled() const { return method == "sampled"; }
  std::string cos_size_or_usual() const;
  CellOptions options(std::uint64_t seed) const;
  int grid_number() const;
};

}  // namespace provis
