#pragma once
// Values grouped by a small whole number, in flat arrays, in parallel.

#include <atomic>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "src/scene/parallel.hpp"

namespace provis {

/// The values of each key, in no particular order.
template <class Value>
class Grouped {
 public:
  /// emit(item, add) calls add(key, value) for each pair of an item, the same pairs whenever it is called.
  template <class Emit>
  Grouped(std::size_t keys, std::size_t items, const Emit& emit) : ends_(keys, 0) {
    const auto slot = [this](std::size_t key) { return std::atomic_ref<std::uint64_t>(ends_[key]); };
    const auto relaxed = std::memory_order_relaxed;
    parallel_for(items, [&](std::size_t item) {
      emit(item, [&](std::size_t key, Value) { slot(key).fetch_add(1, relaxed); });
    });
    std::uint64_t total = 0;
    for (std::uint64_t& end : ends_) total += std::exchange(end, total);
    values_.resize(total);
    // Each group's end begins at its beginning and moves as the group fills.
    parallel_for(items, [&](std::size_t item) {
      emit(item, [&](std::size_t key, Value value) { values_[slot(key).fetch_add(1, relaxed)] = value; });
    });
  }

  std::size_t keys() const { return ends_.size(); }

  std::span<Value> of(std::size_t key) {
    const std::uint64_t begin = key == 0 ? 0 : ends_[key - 1];
    return std::span(values_).subspan(begin, ends_[key] - begin);
  }

 private:
  std::vector<std::uint64_t> ends_;
  std::vector<Value> values_;
};

}  // namespace provis
