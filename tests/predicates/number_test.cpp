// The numbers of the interval and MPFR tiers: they hold the true value, and never call anything else zero.

#include <catch2/catch.hpp>

#include <cmath>
#include <utility>
#include <vector>

#include "predicates/environment.hpp"
#include "predicates/exact_number.hpp"
#include "predicates/interval.hpp"
#include "predicates/mpfi_number.hpp"
#include "tests/predicates/near_degenerate.hpp"

namespace provis::test {
namespace {

/// The same random straight-line program over any number type.
template <class N>
std::vector<N> run_program(std::uint64_t seed, int steps) {
  Random r(seed);
  std::vector<N> v;
  for (int k = 0; k < 5; ++k) v.push_back(N(r.chance(10) ? 0.0 : any_number(r)));
  for (int k = 0; k < steps; ++k) {
    const N &a = v[r.below(v.size())], &b = v[r.below(v.size())];
    N c = a;
    switch (r.below(4)) {
      case 0:
        c = a + b;
        break;
      case 1:
        c = a - b;
        break;
      case 2:
        c = a * b;
        break;
      default:
        c = -a;
    }
    v[r.below(v.size())] = std::move(c);
  }
  return v;
}

bool holds(const Interval& i, const ExactNumber& x) {
  const bool above =
      !std::isfinite(i.inf()) ? i.inf() < 0 : sign_of(x - ExactNumber(i.inf())) != Sign::negative;
  const bool below =
      !std::isfinite(i.sup()) ? i.sup() > 0 : sign_of(ExactNumber(i.sup()) - x) != Sign::negative;
  return above && below;
}

}  // namespace

TEST_CASE("interval: holds the true value through overflow and underflow") {
  for (const std::uint64_t seed : seeds()) {
    INFO("PROVIS_SEED=" << seed);
    const auto exact = run_program<ExactNumber>(seed, 8);
    const RoundUp guard;
    const auto intervals = run_program<Interval>(seed, 8);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      CAPTURE(intervals[k].inf(), intervals[k].sup());
      CHECK(holds(intervals[k], exact[k]));
      if (const auto s = sign_of(intervals[k])) CHECK(*s == sign_of(exact[k]));
    }
  }
}

TEST_CASE("mpfi number: a sign it gives is right at every precision") {
  for (const std::uint64_t seed : seeds(50)) {
    INFO("PROVIS_SEED=" << seed);
    const auto exact = run_program<ExactNumber>(seed, 8);
    for (const long bits : {53L, 212L, 20000L}) {
      const RoundUp guard;
      const MpfiPrecision precision(bits);
      const auto numbers = run_program<MpfiNumber>(seed, 8);
      for (std::size_t k = 0; k < exact.size(); ++k) {
        CAPTURE(bits, k);
        const auto s = sign_of(numbers[k]);
        if (s) CHECK(*s == sign_of(exact[k]));
      }
    }
  }
}

TEST_CASE("mpfi number: enough precision always decides, zero too") {
  const ExactNumber huge(0x1p1000), tiny(0x1p-1074);
  CHECK(sign_of(huge + tiny - huge) == Sign::positive);
  const auto decides = [](long bits) {
    const MpfiPrecision precision(bits);
    const MpfiNumber a(0x1p1000), b(0x1p-1074);
    return std::pair(sign_of(a + b - a), sign_of(a + b - a - b));
  };
  CHECK(decides(212) == std::pair(std::optional<Sign>(), std::optional<Sign>()));
  CHECK(decides(2075) == std::pair(std::optional(Sign::positive), std::optional(Sign::zero)));
}

TEST_CASE("mpfi number: copies, moves and the precision of a scope") {
  const MpfiPrecision outer(212);
  {
    const MpfiPrecision inner(53);
    CHECK(MpfiPrecision::current() == 53);
  }
  CHECK(MpfiPrecision::current() == 212);
  MpfiNumber a(3), b(a);
  a = b - a;
  CHECK(sign_of(a) == Sign::zero);
  MpfiNumber c = std::move(b);
  CHECK(sign_of(c) == Sign::positive);
  b = MpfiNumber(-1);
  CHECK(sign_of(b) == Sign::negative);
  MpfiNumber& self = c;
  c = self;
  CHECK(sign_of(c - MpfiNumber(3)) == Sign::zero);
}

}  // namespace provis::test
