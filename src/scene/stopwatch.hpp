#pragma once
// What a query costs.

#include <chrono>
#include <ctime>

#include "provis/visible_set.hpp"

namespace provis {

/// Wall clock and processor time since it was made.
class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }

  void read(QueryStats& stats) const {
    stats.seconds = seconds();
    stats.cpu_seconds = cpu_seconds() - cpu_;
  }

 private:
  /// Of all threads of the process.
  static double cpu_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
  double cpu_ = cpu_seconds();
};

}  // namespace provis
