#pragma once
// Halving a part of the window until there is little in it: in parallel, and added up in a fixed order.

#include "provis/error.hpp"
#include "src/point/engine.hpp"
#include "src/point/looks.hpp"

namespace provis {

struct DescentState {
  int depth = 0;
  int stalls = 0;  ///< halvings in a row that separated next to nothing
  int axis = 0;    ///< to be halved next
};

/// Work says what a Part is and how it is halved. What certainly is not seen in a part is dropped from its
/// list until work.takes(part, list, progress); then work(part, list) is that part's answer. A part that
/// cannot be halved has to be taken.
template <class Work>
class BlockDescent {
 public:
  using Part = typename Work::Part;
  using List = std::vector<std::uint32_t>;

  BlockDescent(const FrameQuery& query, const Facets& facets, const Work& work)
      : query_(query), facets_(facets), work_(work) {}

  Outcome run(const Part& whole) const { return descend(whole, overlapping(facets_, query_.window), {}); }

 private:
  static constexpr int task_depth = 10;

  Outcome descend(const Part& part, List list, DescentState at) const;
  template <class First, class Second>
  static void both(bool parallel, const First& first, const Second& second);

  const FrameQuery& query_;
  const Facets& facets_;
  const Work& work_;
};

template <class Work>
template <class First, class Second>
void BlockDescent<Work>::both(bool parallel, const First& first, const Second& second) {
  if (parallel) {
    parallel_invoke(first, second);
  } else {
    first();
    second();
  }
}

template <class Work>
Outcome BlockDescent<Work>::descend(const Part& part, List list, DescentState at) const {
  if (query_.context.cancelled()) throw Error(Error::Code::cancelled, "point", "interrupted");
  if (work_.takes(part, list, at)) {
    Outcome outcome = work_(part, list);
    query_.progress.add(std::ldexp(work_.share(), -at.depth));
    return outcome;
  }
  const std::pair<Part, Part> halves = work_.halves(part, at.axis);
  const Part &a = halves.first, &b = halves.second;
  List in_a, in_b;
  const bool parallel = at.depth < task_depth;
  both(
      parallel, [&] { in_a = overlapping(facets_, list, work_.window(a)); },
      [&] { in_b = overlapping(facets_, list, work_.window(b)); });
  const bool stalled = 10 * std::min(in_a.size(), in_b.size()) > 9 * list.size();
  const bool half_is_empty = in_a.empty() || in_b.empty();
  const DescentState next{at.depth + 1, stalled ? at.stalls + 1 : 0, next_axis(at.axis, half_is_empty)};
  list = {};
  Outcome first, second;
  both(
      parallel, [&] { first = descend(a, std::move(in_a), next); },
      [&] { second = descend(b, std::move(in_b), next); });
  first.add(std::move(second));
  return first;
}

}  // namespace provis
