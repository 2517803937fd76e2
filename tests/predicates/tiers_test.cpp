// Every tier that answers, in every rounding mode, gives the sign of an independent rational reference.

#include <catch2/catch.hpp>

#include <optional>
#include <string>

#include "predicates/environment.hpp"
#include "predicates/exact_number.hpp"
#include "predicates/interval.hpp"
#include "predicates/mpfi_number.hpp"
#include "tests/predicates/drawing.hpp"
#include "tests/predicates/rounding_modes.hpp"

namespace provis::test {
namespace {

bool agrees(std::optional<Sign> answer, Sign truth) { return !answer || *answer == truth; }

template <class N>
auto value_at(const ViewGeometry& g, const Line& l, const Direction& d) {
  return dot(provis::evaluate<N>(g, l), provis::evaluate<N>(g, d));
}

/// The two float64 filters, in the calling thread's rounding mode.
void check_filters(const ViewGeometry& g, const Line& line, const Direction& direction, Sign truth) {
  const FilteredValue f = provis::evaluate(line.approx, direction.approx);
  CHECK(agrees(certain_sign(f.value, f.bound), truth));
  CHECK(agrees(certain_sign(value_at<Ball>(g, line, direction)), truth));
}

/// The tiers behind them, each on its own.
void check_slow_tiers(const ViewGeometry& g, const Line& line, const Direction& direction, Sign truth) {
  const RoundUp guard;
  CHECK(agrees(sign_of(value_at<Interval>(g, line, direction)), truth));
  const MpfiPrecision precision(212);
  CHECK(agrees(sign_of(value_at<MpfiNumber>(g, line, direction)), truth));
  CHECK(sign_of(value_at<ExactNumber>(g, line, direction)) == truth);
}

void check_sides(NearFamily family, std::uint64_t seed) {
  Drawing drawing(family, seed);
  const ViewGeometry& g = drawing.input.geometry;
  SignCounts counts;
  const Signs<Arithmetic::chain> signs(g, counts);
  for (const int mode : all_modes) {
    {
      const RoundingMode guard(mode);
      drawing.cast_shadows(signs);
    }
    for (const auto& [line, direction] : drawing.pairs(3)) {
      const Sign truth = drawing.reference.side(line, direction);
      CAPTURE(mode, int(line.kind), int(direction.kind), g.at_infinity);
      {
        const RoundingMode guard(mode);
        check_filters(g, line, direction, truth);
      }
      if (mode == FE_UPWARD) check_slow_tiers(g, line, direction, truth);
      if (on_line_by_structure(line, direction)) CHECK(truth == Sign::zero);
    }
  }
}

template <class Formula>
void check_value(const Formula& formula, Sign truth) {
  for (const int mode : all_modes) {
    const RoundingMode guard(mode);
    CHECK(agrees(certain_sign(formula.template operator()<Ball>()), truth));
  }
  const RoundUp guard;
  CHECK(agrees(sign_of(formula.template operator()<Interval>()), truth));
  const MpfiPrecision precision(212);
  CHECK(agrees(sign_of(formula.template operator()<MpfiNumber>()), truth));
  CHECK(sign_of(formula.template operator()<ExactNumber>()) == truth);
}

void check_facing_and_front(NearFamily family, std::uint64_t seed) {
  const Input in = make_input(family, seed);
  const Reference reference(in.geometry);
  const Vec3d &a = in.points[0], &b = in.points[1], &c = in.points[2], &p = in.points[6];
  check_value([&]<class N>() { return triangle_plane<N>(in.geometry, a, b, c).at_eye; },
              reference.facing(a, b, c));
  check_value([&]<class N>() { return beyond_window<N>(in.geometry, p); }, reference.front(p));
}

void check_vanishing(NearFamily family, std::uint64_t seed) {
  Drawing drawing(family, seed);
  SignCounts counts;
  for (Line& line : drawing.lines) {
    if (line.kind != LineKind::depth) continue;
    const bool truth = Reference::coplanar(line.first, line.second);
    for (const int mode : all_modes) {
      const RoundingMode guard(mode);
      line.approx = Signs<Arithmetic::chain>(drawing.input.geometry, counts).shadow(line);
      if (line.approx.size > line.approx.radius) CHECK_FALSE(truth);
    }
    const RoundUp guard;
    CHECK(Signs<Arithmetic::chain>(drawing.input.geometry, counts).vanishes(line) == truth);
    CHECK(Signs<Arithmetic::exact>(drawing.input.geometry, counts).vanishes(line) == truth);
  }
}

template <class Check>
void for_families(const Check& check) {
  for (const NearFamily family : families) DYNAMIC_SECTION(name(family)) {
      // Exponents all over the range make every exact number thousands of bits long.
      for (const std::uint64_t seed : seeds(family == NearFamily::extreme ? 10 : 50)) {
        INFO("PROVIS_SEED=" << seed);
        check(family, seed);
      }
    }
}

}  // namespace

TEST_CASE("side: no tier is ever wrong") { for_families(check_sides); }

TEST_CASE("facing and front: no tier is ever wrong") { for_families(check_facing_and_front); }

TEST_CASE("vanishes: no tier is ever wrong") { for_families(check_vanishing); }

}  // namespace provis::test
