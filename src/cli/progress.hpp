#pragma once
// How far a query has come, on one line of a terminal.

#include <chrono>
#include <cstddef>
#include <string>

#include "provis/context.hpp"

namespace provis {

/// "42.0 %, 3.5 %/s, 17 s left"; rate and time left appear once there is something to tell them from.
std::string progress_text(const Progress& progress, double seconds);

/// Writes to standard error if that is a terminal, else nowhere; the line is gone when the object is.
class ProgressLine {
 public:
  ProgressLine();
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  bool enabled() const { return terminal_; }
  void show(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  bool terminal_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
  std::size_t shown_ = 0;  ///< width of the text on the line
};

}  // namespace provis
