#pragma once
// How far a query has come.

#include <algorithm>
#include <mutex>

#include "provis/context.hpp"

namespace provis {

/// Reports progress for the whole query, from one thread at a time.
class ProgressMeter {
 public:
  ProgressMeter(const Context& context, double total) : context_(context), total_(total) {}
  void add(double share) {
    if (!context_.on_progress) return;
    const std::lock_guard lock(mutex_);
    done_ = std::min(total_, done_ + share);
    context_.on_progress({done_, total_});
  }

 private:
  const Context& context_;
  double total_, done_ = 0;
  std::mutex mutex_;
};

}  // namespace provis
