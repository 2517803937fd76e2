#pragma once
// The floating-point environment that interval arithmetic and the filters rely on.

#include <cfenv>

namespace provis {

/// Rounds towards +infinity for the life of the object, as CGAL's unprotected intervals need. One stands
/// at the top of every task: a worker thread does not inherit the mode of whoever started it.
class RoundUp {
 public:
  RoundUp() : saved_(std::fegetround()) { std::fesetround(FE_UPWARD); }
  ~RoundUp() { std::fesetround(saved_); }
  RoundUp(const RoundUp&) = delete;
  RoundUp& operator=(const RoundUp&) = delete;

 private:
  int saved_;
};

/// Rounds to nearest for the life of the object: what "plain doubles" means to everybody.
class RoundNearest {
 public:
  RoundNearest() : saved_(std::fegetround()) { std::fesetround(FE_TONEAREST); }
  ~RoundNearest() { std::fesetround(saved_); }
  RoundNearest(const RoundNearest&) = delete;
  RoundNearest& operator=(const RoundNearest&) = delete;

 private:
  int saved_;
};

/// Checks on this thread that products and sums are not contracted, that the rounding mode is obeyed,
/// and that subnormal numbers are not flushed to zero.
///
/// Throws:     Error::internal naming the broken assumption
void check_environment();

/// Whether the calling thread rounds upwards now; the interval tier refuses to work otherwise.
bool rounds_up();

}  // namespace provis
