#include "src/scene/slerp.hpp"

#include <fmt/format.h>
#include <mpfi.h>

#include <optional>

#include "predicates/mpfi_number.hpp"
#include "provis/error.hpp"

namespace provis {
namespace {

constexpr long first_bits = 200;

/// An interval at the precision of the scope.
struct Enclosure {
  Enclosure() { mpfi_init2(value, MpfiPrecision::current()); }
  ~Enclosure() { mpfi_clear(value); }
  Enclosure(const Enclosure&) = delete;
  Enclosure& operator=(const Enclosure&) = delete;

  /// The float64 number nearest to all of it, if it is the same for both ends.
  std::optional<double> nearest() const {
    const double low = mpfr_get_d(&value->left, MPFR_RNDN), high = mpfr_get_d(&value->right, MPFR_RNDN);
    return low == high ? std::optional(low) : std::nullopt;
  }

  mpfi_t value;
};

/// sin(share * angle) / sin(angle)
std::optional<double> nearest_ratio(const Enclosure& share, const Enclosure& angle) {
  Enclosure part, whole;
  mpfi_mul(part.value, share.value, angle.value);
  mpfi_sin(part.value, part.value);
  mpfi_sin(whole.value, angle.value);
  mpfi_div(part.value, part.value, whole.value);
  return part.nearest();
}

std::optional<SlerpFactors> factors_at(long bits, double cosine, double u) {
  const MpfiPrecision precision(bits);
  Enclosure angle, share, rest;
  mpfi_set_d(angle.value, cosine);
  mpfi_acos(angle.value, angle.value);
  mpfi_set_d(share.value, u);
  mpfi_ui_sub(rest.value, 1, share.value);
  const auto from = nearest_ratio(rest, angle), to = nearest_ratio(share, angle);
  if (!from || !to) return std::nullopt;
  return SlerpFactors{*from, *to};
}

}  // namespace

// At u = 0 and u = 1 the first bits do. Otherwise more bits always settle it, since neither ratio is a dyadic
// number, much less one midway between two float64 numbers. Take the second (the first is that of 1 - u). Let
// u = m/2^n with m odd, b = a/2^n, x = 2 cos b: the ratio is P(x)/Q(x), P and Q monic with integer
// coefficients, of degrees m - 1 and 2^n - 1, and 2c = 2 cos a comes from x by n times y -> y^2 - 2. If 2c
// has k > 0 binary places, 2 divides x to the power -k/2^n and so the ratio to the power k(1 - u) > 0: a
// dyadic ratio would be a whole number, but it lies between 0 and 1. If 2c is 0 or 1, then a is 90 or 60
// degrees, and Niven's theorem leaves ratios whose squares are no squares of rationals.
SlerpFactors slerp_factors(double cosine, double u) {
  if (!(cosine >= 0 && cosine < 1 && u >= 0 && u <= 1))
    throw Error(Error::Code::internal, "slerp", fmt::format("cosine {}, parameter {}", cosine, u));
  for (long bits = first_bits;; bits *= 2)
    if (const auto factors = factors_at(bits, cosine, u)) return *factors;
}

}  // namespace provis
