#pragma once
// The threads that a Context lends, and the loops that run on them.

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_reduce.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstddef>

#include "provis/context.hpp"
#include "src/scene/task_order.hpp"

namespace provis {

inline int thread_count(const Context& context) {
  return context.threads > 0 ? context.threads : tbb::this_task_arena::max_concurrency();
}

/// Runs the work on as many threads as the context says, and returns what it returns.
template <class Work>
auto on_threads(const Context& context, const Work& work) {
  const int threads = thread_count(context);
  // An arena may hold more threads than there are cores only where the global limit allows it.
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads);
  TaskOrder order;
  return arena.execute([&] { return order.task(work); });
}

/// body(i) for every i below count.
template <class Body>
void parallel_for(std::size_t count, const Body& body) {
  TaskOrder order;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { order.task([&] { body(i); }); });
}

/// The same where the bodies differ much in cost: each is handed out on its own, in order.
template <class Body>
void parallel_queue(std::size_t count, const Body& body) {
  std::atomic<std::size_t> next = 0;
  parallel_for(count, [&](std::size_t) { body(next.fetch_add(1, std::memory_order_relaxed)); });
}

/// Runs loops inside of a body, which takes no other body of the outer loop meanwhile: what a body holds is
/// held once per thread.
template <class Work>
void parallel_within(const Work& work) {
  tbb::this_task_arena::isolate(work);
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
  TaskOrder order;
  tbb::parallel_invoke([&] { order.task(first); }, [&] { order.task(second); });
}

/// Sums over runs of [0, count): add(begin, end, sum) adds a run to a sum, join(a, b) joins sums in order.
template <class Sum, class Add, class Join>
Sum parallel_sum(std::size_t count, const Sum& zero, const Add& add, const Join& join) {
  using Range = tbb::blocked_range<std::size_t>;
  TaskOrder order;
  return tbb::parallel_reduce(
      Range(0, count), zero,
      [&](const Range& run, Sum sum) { return order.task([&] { return add(run.begin(), run.end(), sum); }); },
      [&](const Sum& a, const Sum& b) { return order.task([&] { return join(a, b); }); });
}

}  // namespace provis
