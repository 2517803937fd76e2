#pragma once
// The options that say which box is looked from.

#include <string>

#include "provis/cell.hpp"

namespace CLI {
class App;
}

namespace provis {

struct CellPlace {
  static constexpr const char* group = "The cell";  ///< in --help

  std::string center, edge;

  void add_to(CLI::App& command);

  bool given() const { return !center.empty() || !edge.empty(); }

  Vec3d middle() const;

  /// Without a window.
  ///
  /// Throws:     Error::usage naming the option
  ViewCell cell() const;
};

}  // namespace provis
