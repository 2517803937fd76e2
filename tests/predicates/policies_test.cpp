// Four policies ask the same questions; three of them must give the same answers.

#include <catch2/catch.hpp>

#include <numeric>

#include "predicates/environment.hpp"
#include "tests/predicates/drawing.hpp"

namespace provis::test {
namespace {

std::uint64_t total(const SignCounts& c) {
  std::uint64_t sum = 0;
  for (const auto& tiers : c.decided) sum = std::accumulate(tiers.begin(), tiers.end(), sum);
  return sum;
}

std::uint64_t total(const SignCounts& c, Tier t) {
  std::uint64_t sum = 0;
  for (const auto& tiers : c.decided) sum += tiers[static_cast<std::size_t>(t)];
  return sum;
}

/// Everything a policy says about one drawing, in order.
template <Arithmetic A>
std::vector<Sign> answers(NearFamily family, std::uint64_t seed, SignCounts& counts) {
  const std::conditional_t<A == Arithmetic::doubles, RoundNearest, RoundUp> guard;
  Drawing drawing(family, seed);
  Signs<A> signs(drawing.input.geometry, counts);
  drawing.cast_shadows(signs);
  std::vector<Sign> said;
  const auto& [a, b, c, d, e, f, p] = drawing.input.points;
  said.push_back(signs.facing(a, b, c));
  said.push_back(signs.facing(d, e, f));
  said.push_back(signs.front(p));
  for (const auto& [line, direction] : drawing.pairs(6)) said.push_back(signs.side(line, direction));
  for (const Line& line : drawing.lines)
    if (line.kind == LineKind::depth) said.push_back(signs.vanishes(line) ? Sign::zero : Sign::positive);
  CHECK(total(counts) == said.size());
  return said;
}

}  // namespace

TEST_CASE("policies: chain, mpfr and exact agree, and doubles ends") {
  for (const NearFamily family : families) DYNAMIC_SECTION(name(family)) {
      // Precision has to grow until nothing is rounded, which takes long where exponents are all over the
      // range.
      for (const std::uint64_t seed : seeds(family == NearFamily::extreme ? 1 : 50)) {
        INFO("PROVIS_SEED=" << seed);
        SignCounts chain, mpfr, exact, doubles;
        const std::vector<Sign> expected = answers<Arithmetic::exact>(family, seed, exact);
        CHECK(answers<Arithmetic::chain>(family, seed, chain) == expected);
        CHECK(answers<Arithmetic::mpfr>(family, seed, mpfr) == expected);
        CHECK(answers<Arithmetic::doubles>(family, seed, doubles).size() == expected.size());
        CHECK(total(exact, Tier::exact) + total(exact, Tier::structure) == total(exact));
        CHECK(total(mpfr, Tier::mpfr) + total(mpfr, Tier::structure) == total(mpfr));
        CHECK(total(doubles, Tier::filter) + total(doubles, Tier::structure) == total(doubles));
      }
    }
}

TEST_CASE("policies: the quick answer is right or absent, and always there for the slow policies") {
  for (const std::uint64_t seed : seeds(50)) {
    INFO("PROVIS_SEED=" << seed);
    const RoundUp guard;
    Drawing drawing(NearFamily::nudged, seed);
    SignCounts counts;
    Signs<Arithmetic::chain> chain(drawing.input.geometry, counts);
    Signs<Arithmetic::exact> exact(drawing.input.geometry, counts);
    drawing.cast_shadows(chain);
    for (const auto& [line, direction] : drawing.pairs(6)) {
      const Sign truth = exact.side(line, direction);
      CHECK(exact.quick_side(line, direction) == truth);
      if (const auto quick = chain.quick_side(line, direction)) CHECK(*quick == truth);
    }
  }
}

TEST_CASE("policies: plain doubles are wrong now and then, which is what they are for") {
  std::size_t wrong = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SignCounts counts;
    const auto rounded = answers<Arithmetic::doubles>(NearFamily::coplanar, seed, counts);
    counts = {};
    const auto exact = answers<Arithmetic::exact>(NearFamily::coplanar, seed, counts);
    for (std::size_t k = 0; k < exact.size(); ++k) wrong += rounded[k] != exact[k];
  }
  CHECK(wrong > 0);
}

TEST_CASE("policies: counts of tasks add up") {
  SignCounts a, b;
  a.at(Predicate::turn, Tier::filter) = 2;
  b.at(Predicate::turn, Tier::filter) = 3;
  b.at(Predicate::coplanar, Tier::exact) = 1;
  a += b;
  CHECK(a.at(Predicate::turn, Tier::filter) == 5);
  CHECK(a.at(Predicate::coplanar, Tier::exact) == 1);
  CHECK(total(a) == 6);
}

TEST_CASE("policies: everything that is counted has a name of its own") {
  std::vector<std::string_view> names;
  for (int p = 0; p < predicate_count; ++p) names.push_back(name(Predicate(p)));
  for (int t = 0; t < tier_count; ++t) names.push_back(name(Tier(t)));
  for (std::size_t k = 0; k < names.size(); ++k) {
    CHECK(names[k] != "?");
    for (std::size_t m = 0; m < k; ++m) CHECK(names[k] != names[m]);
  }
  CHECK(name(Arithmetic::doubles) == "doubles");
  CHECK(name(Arithmetic::chain) == "chain");
  CHECK(name(Arithmetic::mpfr) == "mpfr");
  CHECK(name(Arithmetic::exact) == "exact");
}

}  // namespace provis::test
