#include "predicates/mpfi_number.hpp"

#include <utility>

namespace provis {
namespace {

/// MPFR keeps numbers for reuse per thread; they go when the thread does.
struct MpfrCache {
  ~MpfrCache() { mpfr_free_cache(); }
};

}  // namespace

constinit thread_local long MpfiPrecision::current_ = 212;

MpfiPrecision::MpfiPrecision(long bits) : saved_(current_) {
  static thread_local const MpfrCache cache;
  current_ = bits;
}

MpfiNumber::MpfiNumber() {
  mpfi_init2(i_, MpfiPrecision::current());
  mpfi_set_si(i_, 0);
}

MpfiNumber::MpfiNumber(double exact) {
  mpfi_init2(i_, MpfiPrecision::current());
  mpfi_set_d(i_, exact);
}

MpfiNumber::MpfiNumber(const MpfiNumber& other) {
  mpfi_init2(i_, MpfiPrecision::current());
  mpfi_set(i_, other.i_);
}

MpfiNumber::MpfiNumber(MpfiNumber&& other) noexcept {
  mpfi_init2(i_, MPFR_PREC_MIN);
  mpfi_swap(i_, other.i_);
}

MpfiNumber& MpfiNumber::operator=(MpfiNumber other) noexcept {
  mpfi_swap(i_, other.i_);
  return *this;
}

MpfiNumber::~MpfiNumber() { mpfi_clear(i_); }

MpfiNumber operator+(const MpfiNumber& a, const MpfiNumber& b) {
  MpfiNumber r;
  mpfi_add(r.i_, a.i_, b.i_);
  return r;
}

MpfiNumber operator-(const MpfiNumber& a, const MpfiNumber& b) {
  MpfiNumber r;
  mpfi_sub(r.i_, a.i_, b.i_);
  return r;
}

MpfiNumber operator*(const MpfiNumber& a, const MpfiNumber& b) {
  MpfiNumber r;
  mpfi_mul(r.i_, a.i_, b.i_);
  return r;
}

MpfiNumber operator-(const MpfiNumber& a) {
  MpfiNumber r;
  mpfi_neg(r.i_, a.i_);
  return r;
}

std::optional<Sign> sign_of(const MpfiNumber& a) {
  if (mpfi_is_strictly_pos(a.i_) > 0) return Sign::positive;
  if (mpfi_is_strictly_neg(a.i_) > 0) return Sign::negative;
  if (mpfi_is_zero(a.i_) > 0) return Sign::zero;
  return std::nullopt;
}

}  // namespace provis
