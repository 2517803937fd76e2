#include "src/segment/sign_check.hpp"

#include "predicates/environment.hpp"

namespace provis {

void SignCheck::add(MovingFacet facet) {
  // Its functions were rounded in another mode: without them every question goes to intervals and exact
  // numbers.
  facet.along.error = HUGE_VAL;
  certain_.add(facet);
}

bool SignCheck::wrong_span(const Pixel& at, const Centre& centre, std::uint32_t facet, const TimeRange& range,
                           const Span* taken) {
  const RoundUp guard;
  const std::optional<Span> is = certain_.span(at, centre, facet, range);
  if (!is || taken == nullptr) return is.has_value() != (taken != nullptr);
  const auto moved = [&](const Event& said, const Event& true_one) {
    const Event e = certain_.restated(at, said);
    return e.slope == Sign::zero || certain_.compare(at, e, true_one) != Sign::zero;
  };
  return is->shown.side != taken->shown.side || moved(taken->begin, is->begin) || moved(taken->end, is->end);
}

bool SignCheck::wrong_order(const Pixel& at, const Event& a, const Event& b, Sign taken) {
  const RoundUp guard;
  const Event first = certain_.restated(at, a), second = certain_.restated(at, b);
  if (first.slope == Sign::zero || second.slope == Sign::zero) return true;
  return certain_.compare(at, first, second) != taken;
}

bool SignCheck::wrong_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when, Sign taken) {
  const RoundUp guard;
  const Shown first = certain_.restated(at, a), second = certain_.restated(at, b);
  const Event e = certain_.restated(at, when);
  if (first.side == Sign::zero || second.side == Sign::zero || e.slope == Sign::zero) return true;
  return certain_.compare_depth(at, first, second, e) != taken;
}

}  // namespace provis
