#pragma once
// This program once more, as a child that may take only so much time and memory.

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace provis {

struct Limits {
  double seconds = 0;       ///< wall clock, from its start to its end
  std::uint64_t bytes = 0;  ///< of data; 0 for no limit
};

struct ChildEnd {
  int status = -1;  ///< exit status; -1 if it did not exit by itself
  int signal = 0;   ///< that ended it; 0 if it exited
  bool timed_out = false;
  bool out_of_memory = false;  ///< by its own account
  std::string complaint;       ///< the last line that it said on standard error, without "provis: error: "
};

/// Runs the program with these arguments and waits for its end; what it writes to standard output is dropped.
/// The child ends with this process, whatever ends it.
///
/// Throws:     Error::cancelled once the flag is set (null: never), after the child was ended;
///             Error::internal if there can be no child
ChildEnd run_limited_child(const std::vector<std::string>& arguments, const Limits& limits,
                           const std::atomic<bool>* cancel);

}  // namespace provis
