// Everything rests on the exact tier's number, so it is held against rationals operation by operation.

#include <catch2/catch.hpp>

#include <utility>
#include <vector>

#include "predicates/exact_number.hpp"
#include "tests/predicates/near_degenerate.hpp"
#include "tests/predicates/reference.hpp"

namespace provis::test {
namespace {

bool same(const ExactNumber& x, const Rational& q) {
  return Rational(x) == q && sign_of(x) == rational_sign(q) && x.is_canonical();
}

/// Numbers of both kinds side by side, through whatever happens to them.
struct Pool {
  std::vector<ExactNumber> exact;
  std::vector<Rational> rational;
  std::vector<int> degree;

  void add(double d) {
    exact.emplace_back(d);
    rational.emplace_back(d);
    degree.push_back(1);
  }
  bool same_at(std::size_t k) const { return same(exact[k], rational[k]); }
};

void compute(Pool& p, std::size_t i, std::size_t j, std::size_t to, int operation) {
  if (operation == 2 && p.degree[i] + p.degree[j] > 15) return;
  const int degree = operation == 2 ? p.degree[i] + p.degree[j] : std::max(p.degree[i], p.degree[j]);
  const Rational q = operation == 0   ? p.rational[i] + p.rational[j]
                     : operation == 1 ? p.rational[i] - p.rational[j]
                                      : p.rational[i] * p.rational[j];
  // Assigning in place makes the target an operand, too, now and then.
  p.exact[to] = operation == 0   ? p.exact[i] + p.exact[j]
                : operation == 1 ? p.exact[i] - p.exact[j]
                                 : p.exact[i] * p.exact[j];
  p.rational[to] = q;
  p.degree[to] = degree;
}

void shuffle_about(Pool& p, std::size_t i, std::size_t j, int way) {
  switch (way) {
    case 0: {
      ExactNumber& self = p.exact[i];
      p.exact[i] = self;
      return;
    }
    case 1: {
      ExactNumber& self = p.exact[i];
      p.exact[i] = std::move(self);
      return;
    }
    case 2:  // growth moves every element
      p.exact.push_back(p.exact[i]);
      p.rational.push_back(p.rational[i]);
      p.degree.push_back(p.degree[i]);
      return;
    case 3:
      std::swap(p.exact[i], p.exact[j]);
      std::swap(p.rational[i], p.rational[j]);
      std::swap(p.degree[i], p.degree[j]);
      return;
    case 4: {  // what was moved from can be assigned to
      ExactNumber away = std::move(p.exact[i]);
      p.exact[i] = ExactNumber(1.5);
      p.exact[i] = std::move(away);
      return;
    }
    default:
      p.exact[j] = -p.exact[i];
      p.rational[j] = -p.rational[i];
      p.degree[j] = p.degree[i];
  }
}

}  // namespace

TEST_CASE("exact number: float64 values of every kind arrive unchanged") {
  for (const double d :
       {0.0, -0.0, 1.0, -1.0, 0x1p-1074, -0x1p-1074, 0x1.fffffffffffffp-1023, 0x1p-1022,
        0x1.fffffffffffffp1023, -0x1.fffffffffffffp1023, 0x1p63, 0x1p64, 0x1p-64, 0x1.8p-63}) {
    CAPTURE(d);
    CHECK(same(ExactNumber(d), Rational(d)));
    CHECK(same(-ExactNumber(d), Rational(-d)));
  }
  Random r(1);
  for (std::uint64_t k = 0; k < case_count(); ++k) {
    const double d = any_number(r);
    CAPTURE(d);
    CHECK(same(ExactNumber(d), Rational(d)));
  }
}

TEST_CASE("exact number: arithmetic and moves agree with rationals") {
  for (const std::uint64_t seed : seeds(20)) {
    INFO("PROVIS_SEED=" << seed);
    Random r(seed);
    Pool p;
    for (int k = 0; k < 6; ++k) p.add(any_number(r));
    p.add(0);
    p.add(-p.exact[0].to_double());
    for (int step = 0; step < 30; ++step) {
      const std::size_t n = p.exact.size(), i = r.below(n), j = r.below(n), to = r.below(n);
      r.chance(70) ? compute(p, i, j, to, r.between(0, 2)) : shuffle_about(p, i, j, r.between(0, 5));
      CAPTURE(step, i, j, to);
      CHECK(p.same_at(i));
      CHECK(p.same_at(j));
      CHECK(p.same_at(to));
    }
  }
}

TEST_CASE("exact number: cancellation leaves the small term, or nothing") {
  for (const std::uint64_t seed : seeds()) {
    INFO("PROVIS_SEED=" << seed);
    Random r(seed);
    const ExactNumber a = ExactNumber(any_number(r)) * ExactNumber(any_number(r)), b(any_number(r));
    CHECK(a + b - a == b);
    CHECK(a - (a + b) == -b);
    CHECK(sign_of(a - a) == Sign::zero);
    CHECK(sign_of(a * b - b * a) == Sign::zero);
    CHECK(sign_of((a + b) * (a - b) - (a * a - b * b)) == Sign::zero);
  }
}

}  // namespace provis::test
