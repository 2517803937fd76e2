#pragma once
// What every command gets, and how it is registered.

#include <functional>
#include <string>

#include "provis/context.hpp"

namespace CLI {
class App;
}

namespace provis {

/// One run of the program.
struct Run {
  Context context;
  std::string doing = "reading the command line";  ///< for a message that says what was interrupted

  /// Enters the next stage. Throws Error::cancelled if the user has asked to stop.
  void stage(const std::string& what);
};

/// Does what the command line asked for.
using Action = std::function<void(Run&)>;

/// Each adds one command with its options to the program and returns what it does once they are parsed.
Action add_info(CLI::App& program);
Action add_export(CLI::App& program);
Action add_point(CLI::App& program);
Action add_segment(CLI::App& program);
Action add_cell(CLI::App& program);
Action add_draw(CLI::App& program);
Action add_accuracy(CLI::App& program);

}  // namespace provis
