#pragma once
// The options that limit the directions of a query from a region.

#include <array>
#include <optional>
#include <string>

#include "src/cli/camera_options.hpp"

namespace CLI {
class App;
}

namespace provis {

struct WindowOptions : CameraOptions {
  static constexpr const char* group = "Where to";  ///< in --help

  void add_to(CLI::App& command);

  /// Nothing, the whole sphere, where none of the options was given; otherwise the frame of a camera in the
  /// middle of the region, with windows as wide to high as size.
  ///
  /// Throws:     Error::usage naming the option
  std::optional<Frame> frame(const Vec3d& middle, const std::array<int, 2>& size) const;
};

}  // namespace provis
