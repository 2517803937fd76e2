#pragma once
// What a caller lends to a long computation: threads, a way to stop it, and a way to watch it.

#include <atomic>
#include <functional>

namespace provis {

/// Progress of a running query; done never decreases and ends at total.
struct Progress {
  double done = 0;
  double total = 1;
};

/// Passed to every long-running function. Holds no result and changes no answer.
struct Context {
  /// Worker threads; 0 takes every core that the process may use.
  int threads = 0;
  /// Set it from any thread, or from a signal handler, to end the query with Error::Code::cancelled.
  std::atomic<bool>* cancel = nullptr;
  /// Called now and then, from one thread at a time.
  std::function<void(const Progress&)> on_progress;

  bool cancelled() const { return cancel != nullptr && cancel->load(std::memory_order_relaxed); }
};

}  // namespace provis
