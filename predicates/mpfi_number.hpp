#pragma once
// The MPFR tier's number: an MPFI interval at the precision of a scope.

#include <mpfi.h>

#include <optional>

#include "predicates/sign.hpp"

namespace provis {

/// Sets the precision in bits of the numbers made on this thread while the object lives.
class MpfiPrecision {
 public:
  explicit MpfiPrecision(long bits);
  ~MpfiPrecision() { current_ = saved_; }
  MpfiPrecision(const MpfiPrecision&) = delete;
  MpfiPrecision& operator=(const MpfiPrecision&) = delete;

  static long current() { return current_; }

 private:
  long saved_;
  // constinit: known to need no initialisation at run time, so that other files reach it without a wrapper.
  static constinit thread_local long current_;
};

class MpfiNumber {
 public:
  MpfiNumber();
  MpfiNumber(double exact);  // NOLINT: a float64 number is a point
  MpfiNumber(const MpfiNumber& other);
  MpfiNumber(MpfiNumber&& other) noexcept;
  MpfiNumber& operator=(MpfiNumber other) noexcept;
  ~MpfiNumber();

  friend MpfiNumber operator+(const MpfiNumber& a, const MpfiNumber& b);
  friend MpfiNumber operator-(const MpfiNumber& a, const MpfiNumber& b);
  friend MpfiNumber operator*(const MpfiNumber& a, const MpfiNumber& b);
  friend MpfiNumber operator-(const MpfiNumber& a);

  /// Zero only for the point 0: every value is a dyadic rational, so enough precision always gets there.
  friend std::optional<Sign> sign_of(const MpfiNumber& a);

 private:
  mpfi_t i_;
};

}  // namespace provis
