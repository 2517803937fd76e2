#pragma once
// The options that say where a query looks from, and where to.

#include <string>

#include "src/cli/camera_options.hpp"

namespace CLI {
class App;
}

namespace provis {

struct ViewOptions : CameraOptions {
  static constexpr const char* group = "Where from, where to";  ///< in --help

  std::string eye, projection, views, size;

  void add_to(CLI::App& command);

  /// Throws:     Error::usage naming the option; Error::invalid_input for a bad file of views
  PointView view(const std::string& scene_file) const;
};

}  // namespace provis
