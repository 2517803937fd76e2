// The factors of spherical interpolation against MPFR at ten times the bits and by another formula.
#include "src/scene/slerp.hpp"

#include <mpfr.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "provis/error.hpp"

namespace provis {
namespace {

/// sin(share a) / sin(a) where a = atan2(sqrt(1 - c c), c), rounded to float64 at the end.
double reference(double cosine, double u, bool from) {
  constexpr mpfr_prec_t bits = 4000;
  mpfr_t angle, share, part, whole;
  mpfr_inits2(bits, angle, share, part, whole, nullptr);
  mpfr_set_d(whole, cosine, MPFR_RNDN);
  mpfr_sqr(part, whole, MPFR_RNDN);
  mpfr_ui_sub(part, 1, part, MPFR_RNDN);
  mpfr_sqrt(part, part, MPFR_RNDN);
  mpfr_atan2(angle, part, whole, MPFR_RNDN);
  mpfr_set_d(share, u, MPFR_RNDN);
  if (from) mpfr_ui_sub(share, 1, share, MPFR_RNDN);
  mpfr_mul(part, share, angle, MPFR_RNDN);
  mpfr_sin(part, part, MPFR_RNDN);
  mpfr_sin(whole, angle, MPFR_RNDN);
  mpfr_div(part, part, whole, MPFR_RNDN);
  const double result = mpfr_get_d(part, MPFR_RNDN);
  mpfr_clears(angle, share, part, whole, nullptr);
  return result;
}

void check_factors(double cosine, double u) {
  CAPTURE(cosine, u);
  const SlerpFactors k = slerp_factors(cosine, u);
  CHECK(k.from == reference(cosine, u, true));
  CHECK(k.to == reference(cosine, u, false));
}

TEST_CASE("half way between quaternions at right angles both factors are the root of a half") {
  const SlerpFactors k = slerp_factors(0, 0.5);
  CHECK(k.from == std::sqrt(0.5));
  CHECK(k.to == std::sqrt(0.5));
}

TEST_CASE("the ends have the factors 1 and 0") {
  for (const double cosine : {0.0, 0.3, 1 - 0x1p-53}) {
    CHECK((slerp_factors(cosine, 0).from == 1 && slerp_factors(cosine, 0).to == 0));
    CHECK((slerp_factors(cosine, 1).from == 0 && slerp_factors(cosine, 1).to == 1));
  }
}

// With a small angle and u = 2^-54 the first factor is within 2^-108 of 1 - 2^-54, midway between two
// numbers.
TEST_CASE("factors are correctly rounded where arguments are extreme") {
  for (const double cosine : {0.0, 0x1p-1074, 0x1p-30, 0.5, 1 - 0x1p-20, 1 - 0x1p-53})
    for (const double u : {0x1p-1074, 1e-300, 0x1p-60, 0x1p-55, 0x1p-54, 1.0 / 3, 0.5, 0.75, 1 - 0x1p-53})
      check_factors(cosine, u);
}

TEST_CASE("factors are correctly rounded everywhere, which plain doubles are not") {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0, 1);
  int plain_is_off = 0;
  for (int i = 0; i < 2000; ++i) {
    // Every other angle is small, as between the keys of a smooth animation.
    const double x = unit(random), cosine = i % 2 == 0 ? x : 1 - 1e-4 * x, u = unit(random);
    check_factors(cosine, u);
    plain_is_off +=
        slerp_factors(cosine, u).to != std::sin(u * std::acos(cosine)) / std::sin(std::acos(cosine));
  }
  CHECK(plain_is_off > 100);
}

TEST_CASE("factors out of the domain are an internal error") {
  CHECK_THROWS_AS(slerp_factors(1, 0.5), Error);
  CHECK_THROWS_AS(slerp_factors(-0.5, 0.5), Error);
  CHECK_THROWS_AS(slerp_factors(0.5, 1.5), Error);
  CHECK_THROWS_AS(slerp_factors(0.5, std::nan("")), Error);
}

}  // namespace
}  // namespace provis
