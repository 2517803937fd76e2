#pragma once
// The options that say along which segments a query looks, and through which frames.

#include <string>

#include "provis/result_file.hpp"
#include "src/cli/camera_options.hpp"

namespace CLI {
class App;
}

namespace provis {

struct PathOptions : CameraOptions {
  static constexpr const char* group = "Where from, where to";  ///< in --help

  std::string from, to, rect;
  std::string faces, size, runs;

  /// All of them.
  void add_to(CLI::App& command);
  /// Those that no query from a point has: --from, --to, --rect, --faces.
  void add_paths_to(CLI::App& command);

  /// seed: of --runs
  ///
  /// Throws:     Error::usage naming the option
  SegmentQuery query(std::uint64_t seed) const;

 private:
  std::vector<SegmentQuery::Path> paths() const;
  std::vector<Frame> frames(const Vec3d& eye, std::uint64_t seed) const;
  bool pinhole() const;
};

/// Six faces of a cube, turned by a random rotation: float64 vectors that are a function of seed and run.
std::vector<Frame> turned_cube(std::uint64_t seed, std::uint64_t run);

}  // namespace provis
