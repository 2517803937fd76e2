// Watching plain doubles: they say what they say unwatched, and every sign that is not the exact one is
// counted.

#include <catch2/catch.hpp>

#include <numeric>

#include "predicates/environment.hpp"
#include "tests/predicates/drawing.hpp"

namespace provis::test {
namespace {

struct Said {
  std::vector<Sign> facing, front, sides, coplanar;

  friend bool operator==(const Said&, const Said&) = default;
};

/// Everything a policy says about one drawing.
template <Arithmetic A>
Said answers(NearFamily family, std::uint64_t seed, bool checked, SignCounts& counts) {
  const std::conditional_t<A == Arithmetic::doubles, RoundNearest, RoundUp> guard;
  Drawing drawing(family, seed);
  drawing.input.geometry.checked = checked;
  Signs<A> signs(drawing.input.geometry, counts);
  drawing.cast_shadows(signs);
  Said said;
  const auto& [a, b, c, d, e, f, p] = drawing.input.points;
  said.facing = {signs.facing(a, b, c), signs.facing(d, e, f)};
  said.front = {signs.front(p)};
  for (const auto& [line, direction] : drawing.pairs(6)) {
    said.sides.push_back(signs.side(line, direction));
    if (const auto quick = signs.quick_side(line, direction)) said.sides.push_back(*quick);
  }
  for (const Line& line : drawing.lines)
    if (line.kind == LineKind::depth)
      said.coplanar.push_back(signs.vanishes(line) ? Sign::zero : Sign::positive);
  return said;
}

std::uint64_t differences(const std::vector<Sign>& a, const std::vector<Sign>& b) {
  REQUIRE(a.size() == b.size());
  std::uint64_t count = 0;
  for (std::size_t k = 0; k < a.size(); ++k) count += a[k] != b[k];
  return count;
}

/// Of signs whose predicate depends on line and direction.
std::uint64_t wrong_sides(const SignCounts& counts) {
  return counts.wrong_of(Predicate::turn) + counts.wrong_of(Predicate::turn_constructed) +
         counts.wrong_of(Predicate::nearer) + counts.wrong_of(Predicate::nearer_constructed);
}

}  // namespace

TEST_CASE("checked: as many signs are wrong as differ from the exact ones, and none is changed") {
  std::uint64_t wrong = 0;
  for (const NearFamily family : families) {
    for (const std::uint64_t seed : seeds(family == NearFamily::extreme ? 1 : 20)) {
      INFO(name(family) << ", PROVIS_SEED=" << seed);
      SignCounts exact_counts, counts, unwatched;
      const Said exact = answers<Arithmetic::exact>(family, seed, false, exact_counts);
      const Said doubles = answers<Arithmetic::doubles>(family, seed, true, counts);
      CHECK(doubles == answers<Arithmetic::doubles>(family, seed, false, unwatched));
      CHECK(counts.decided == unwatched.decided);
      CHECK(unwatched.wrong == SignCounts{}.wrong);
      CHECK(counts.wrong_of(Predicate::facing) == differences(doubles.facing, exact.facing));
      CHECK(counts.wrong_of(Predicate::front) == differences(doubles.front, exact.front));
      CHECK(counts.wrong_of(Predicate::coplanar) == differences(doubles.coplanar, exact.coplanar));
      CHECK(wrong_sides(counts) == differences(doubles.sides, exact.sides));
      wrong = std::accumulate(counts.wrong.begin(), counts.wrong.end(), wrong);
    }
  }
  CHECK(wrong > 0);
}

TEST_CASE("checked: certain policies are not watched, and have nothing to be caught at") {
  for (const std::uint64_t seed : seeds(20)) {
    INFO("PROVIS_SEED=" << seed);
    SignCounts counts;
    CHECK(answers<Arithmetic::chain>(NearFamily::nudged, seed, true, counts).facing.size() == 2);
    answers<Arithmetic::exact>(NearFamily::nudged, seed, true, counts);
    CHECK(counts.wrong == SignCounts{}.wrong);
  }
}

TEST_CASE("checked: the rounding mode is as before") {
  const RoundNearest guard;
  Drawing drawing(NearFamily::grid, 1);
  drawing.input.geometry.checked = true;
  SignCounts counts;
  Signs<Arithmetic::doubles> signs(drawing.input.geometry, counts);
  signs.front(drawing.input.points[0]);
  CHECK_FALSE(rounds_up());
}

TEST_CASE("checked: wrong signs of tasks add up") {
  SignCounts a, b;
  a.wrong_of(Predicate::turn) = 2;
  b.wrong_of(Predicate::turn) = 3;
  b.wrong_of(Predicate::front) = 1;
  a += b;
  CHECK(a.wrong_of(Predicate::turn) == 5);
  CHECK(a.wrong_of(Predicate::front) == 1);
}

}  // namespace provis::test
