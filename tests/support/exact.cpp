#include "tests/support/exact.hpp"

#include <algorithm>
#include <cfloat>
#include <climits>
#include <cmath>

namespace provis::test {

namespace {

/// value = mantissa * 2^exponent with an odd integer mantissa; value is not zero.
struct OddMantissa {
  std::int64_t mantissa;
  int exponent;
};

OddMantissa split(double value) {
  int exponent = 0;
  auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  exponent -= 53;
  while (mantissa % 2 == 0) {
    mantissa /= 2;
    ++exponent;
  }
  return {mantissa, exponent};
}

/// The bits of v * 2^shift as float64, truncated.
double shifted(const Integer& v, long shift) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, v.get_mpz_t());
  return std::ldexp(mantissa, static_cast<int>(std::clamp(exponent + shift, -2000L, 2000L)));
}

}  // namespace

void CommonScale::include(double value) {
  if (value != 0) exponent_ = std::max(exponent_, -split(value).exponent);
}

void CommonScale::include(const Vec3d& v) {
  for (const double value : {v.x, v.y, v.z}) include(value);
}

Integer CommonScale::operator()(double value) const {
  if (value == 0) return 0;
  const OddMantissa parts = split(value);
  const Integer mantissa = static_cast<long>(parts.mantissa);
  return mantissa << static_cast<mp_bitcnt_t>(parts.exponent + exponent_);
}

Integer3 CommonScale::operator()(const Vec3d& v) const { return {(*this)(v.x), (*this)(v.y), (*this)(v.z)}; }

CommonScale scale_of(const SceneArrays& scene, const PointView& view) {
  CommonScale scale;
  scale.include(view.eye);
  for (const Triangle& t : scene.triangles) {
    for (const std::uint32_t v : t) scale.include(scene.vertices[v]);
  }
  for (const Frame& frame : view.frames) {
    scale.include(frame.right);
    scale.include(frame.up);
    scale.include(frame.forward);
  }
  return scale;
}

Bounds quotient_bounds(const Integer& numerator, const Integer& denominator) {
  long exponent = 0;
  const double d = mpz_get_d_2exp(&exponent, denominator.get_mpz_t());
  const double value = shifted(numerator, -exponent) / d;
  if (std::isinf(value)) return value > 0 ? Bounds{DBL_MAX, HUGE_VAL} : Bounds{-HUGE_VAL, -DBL_MAX};
  const double margin = std::abs(value) * 0x1p-48 + DBL_MIN;
  return {value - margin, value + margin};
}

void drop_common_twos(Integer3& v) {
  mp_bitcnt_t shared = ULONG_MAX;
  for (const Integer* c : {&v.x, &v.y, &v.z}) {
    if (*c != 0) shared = std::min(shared, mpz_scan1(c->get_mpz_t(), 0));
  }
  if (shared == ULONG_MAX || shared == 0) return;
  for (Integer* c : {&v.x, &v.y, &v.z}) mpz_tdiv_q_2exp(c->get_mpz_t(), c->get_mpz_t(), shared);
}

Shadowed::Shadowed(Integer3 exact) : exact_(std::move(exact)) {
  drop_common_twos(exact_);
  long largest = LONG_MIN;
  for (const Integer* c : {&exact_.x, &exact_.y, &exact_.z}) {
    if (*c != 0) largest = std::max(largest, static_cast<long>(mpz_sizeinbase(c->get_mpz_t(), 2)));
  }
  if (largest == LONG_MIN) return;
  picture_ = {shifted(exact_.x, -largest), shifted(exact_.y, -largest), shifted(exact_.z, -largest)};
}

int sign_of_dot(const Shadowed& a, const Shadowed& b) {
  const double guess = dot(a.picture_, b.picture_);
  if (std::abs(guess) > 0x1p-47) return guess > 0 ? 1 : -1;
  return sgn(dot(a.exact_, b.exact_));
}

}  // namespace provis::test
