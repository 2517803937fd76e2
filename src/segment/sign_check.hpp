#pragma once
// What plain doubles take for true at a pixel, held against certain numbers.

#include "src/segment/events.hpp"

namespace provis {

/// Knows the same facets by the same numbers. Sets the rounding mode that it needs by itself.
///
/// Degenerate: whatever is said of an event that does not exist, or of a facet that is not hit, is wrong
class SignCheck {
 public:
  explicit SignCheck(const PathGeometry& path) : certain_(path, counts_) {}

  void add(MovingFacet facet);
  void clear() { certain_.clear(); }

  /// taken: null where the facet was said not to be hit. Wrong if it is, or from another moment or to another
  /// one.
  bool wrong_span(const Pixel& at, const Centre& centre, std::uint32_t facet, const TimeRange& range,
                  const Span* taken);
  bool wrong_order(const Pixel& at, const Event& a, const Event& b, Sign taken);
  bool wrong_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when, Sign taken);

 private:
  SignCounts counts_;
  Events<Arithmetic::chain> certain_;
};

}  // namespace provis
