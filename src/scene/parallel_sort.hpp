#pragma once
// Sorting on several threads.

#include <algorithm>
#include <span>

#include "src/scene/parallel.hpp"

namespace provis {

/// Halves are sorted side by side, then merged. tbb::parallel_sort is somewhat faster, but what it does
/// between its tasks is hidden from ThreadSanitizer.
template <class T>
void parallel_sort(std::span<T> values) {
  constexpr std::size_t small = 1 << 14;
  if (values.size() <= small) {
    std::sort(values.begin(), values.end());
    return;
  }
  const std::size_t half = values.size() / 2;
  parallel_invoke([&] { parallel_sort(values.first(half)); }, [&] { parallel_sort(values.subspan(half)); });
  std::inplace_merge(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(half), values.end());
}

}  // namespace provis
