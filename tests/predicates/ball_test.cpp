// The filter's numbers against exact ones, in all four rounding modes, over the whole range of float64.

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "predicates/approx.hpp"
#include "predicates/exact_number.hpp"
#include "predicates/formulas.hpp"
#include "tests/predicates/near_degenerate.hpp"
#include "tests/predicates/rounding_modes.hpp"

namespace provis::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double largest_number = std::numeric_limits<double>::max();

/// What a ball stands for: any number within its radius. An unknown one stands for everything.
struct Sample {
  Ball ball;
  ExactNumber truth;
};

double any_radius(double value, Random& r) {
  switch (r.below(5)) {
    case 0:
      return std::fabs(value) * std::ldexp(1.0, -r.between(1, 60));
    case 1:
      return std::fabs(any_number(r));
    case 2:
      return underflow_bound * r.below(4);
    default:
      return 0;
  }
}

Sample any_sample(Random& r) {
  const double value = any_number(r);
  const Ball ball(value, any_radius(value, r));
  const ExactNumber off = ball.radius < infinity
                              ? ExactNumber(r.pick({-1.0, 0.0, 1.0, 0.3})) * ExactNumber(ball.radius)
                              : ExactNumber(any_number(r));
  return {ball, ExactNumber(value) + off};
}

/// A radius without a bound is no claim; any other is one, and then the value is a number.
bool holds(double value, double radius, const ExactNumber& truth) {
  if (radius == infinity) return true;
  if (!std::isfinite(value) || !std::isfinite(radius)) return false;
  const ExactNumber off = truth - ExactNumber(value);
  return sign_of(ExactNumber(radius) - off) != Sign::negative &&
         sign_of(ExactNumber(radius) + off) != Sign::negative;
}

bool holds(const Ball& b, const ExactNumber& truth) { return holds(b.value, b.radius, truth); }

template <class Op>
void check_operation(const Sample& a, const Sample& b, const char* name, const Op& op) {
  const ExactNumber truth = op(a.truth, b.truth);
  for (const int mode : all_modes) {
    Ball result;
    {
      const RoundingMode guard(mode);
      result = op(a.ball, b.ball);
    }
    if (holds(result, truth)) continue;
    CAPTURE(name, mode, a.ball.value, a.ball.radius, b.ball.value, b.ball.radius, result.value,
            result.radius);
    FAIL_CHECK("the true value lies outside the ball");
  }
}

Vec3d any_vector(Random& r) {
  const int size = r.between(-1074, 960), spread = r.between(0, 60);
  const auto coordinate = [&] {
    return std::ldexp(2 * r.unit() - 1, std::min(1023, size + r.between(-spread, spread)));
  };
  const double x = coordinate(), y = coordinate(), z = coordinate();
  // All of one magnitude is the worst case of every bound.
  if (r.chance(50)) return {x, r.pick({-x, x}), r.pick({-x, x})};
  return {x, y, z};
}

struct VectorSample {
  Approx approx;
  Vec3<ExactNumber> truth;
};

VectorSample any_vector_sample(Random& r) {
  const Vec3d v = any_vector(r);
  const double radius = r.chance(50) ? 0 : largest(v) * std::ldexp(1.0, -r.between(1, 70));
  const auto off = [&] { return ExactNumber(r.pick({-1.0, -1.0, 0.0, 1.0, 1.0})) * ExactNumber(radius); };
  return {approximate(v, radius),
          {ExactNumber(v.x) + off(), ExactNumber(v.y) + off(), ExactNumber(v.z) + off()}};
}

}  // namespace

TEST_CASE("ball: sums, differences and products hold the true value in every rounding mode") {
  for (const std::uint64_t seed : seeds(1000)) {
    INFO("PROVIS_SEED=" << seed);
    Random r(seed);
    const Sample a = any_sample(r);
    Sample b = any_sample(r);
    if (r.chance(25)) b = {Ball(nudged(-a.ball.value, r)), {}}, b.truth = ExactNumber(b.ball.value);
    check_operation(a, b, "+", [](const auto& x, const auto& y) { return x + y; });
    check_operation(a, b, "-", [](const auto& x, const auto& y) { return x - y; });
    check_operation(a, b, "*", [](const auto& x, const auto& y) { return x * y; });
    check_operation(a, b, "unary -", [](const auto& x, const auto&) { return -x; });
  }
}

TEST_CASE("approx: cross products and dot products hold the true value in every rounding mode") {
  for (const std::uint64_t seed : seeds(300)) {
    INFO("PROVIS_SEED=" << seed);
    Random r(seed);
    const VectorSample a = any_vector_sample(r), b = any_vector_sample(r);
    const Vec3<ExactNumber> c = cross(a.truth, b.truth);
    const ExactNumber d = dot(a.truth, b.truth);
    for (const int mode : all_modes) {
      Approx product;
      FilteredValue f;
      {
        const RoundingMode guard(mode);
        product = cross(a.approx, b.approx);
        f = evaluate(a.approx, prepare(b.approx));
      }
      CAPTURE(mode, product.v.x, product.v.y, product.v.z, product.radius, f.value, f.bound);
      CHECK(holds(product.v.x, product.radius, c.x));
      CHECK(holds(product.v.y, product.radius, c.y));
      CHECK(holds(product.v.z, product.radius, c.z));
      if (f.bound < infinity) CHECK(holds(f.value, f.bound, d));  // NaN, too, claims nothing
      if (const auto sign = certain_sign(f.value, f.bound)) CHECK(*sign == sign_of(d));
    }
  }
}

TEST_CASE("ball: what may have overflowed is unknown, although it may look finite") {
  const RoundingMode upward(FE_UPWARD);
  // Rounded upwards, -1e400 is the same finite number as -1e310: a difference of both would look certain.
  volatile double large = 0x1p600;  // so that nobody multiplies while compiling, to nearest
  const Ball saturated = Ball(-large) * Ball(large);
  CHECK(saturated.value == -largest_number);
  CHECK(saturated.radius == infinity);
  CHECK((saturated - saturated + Ball(1)).radius == infinity);
  CHECK((saturated * Ball(0)).radius == infinity);
  CHECK((Ball(-largest_number) + Ball(-largest_number)).radius == infinity);
}

TEST_CASE("facing: the sign survives where products saturate") {
  volatile double volatile_scale = 0x1p350;
  const double s = volatile_scale;  // products of degree 3 reach 2^1050
  Frame frame;
  const ViewGeometry g = make_geometry({0, 0, 0}, frame, false);
  const Vec3d a{-4 * s, s, 2 * s}, b{s, 3 * s, -s}, c{2 * s, -s, 5 * s};
  const Sign truth = sign_of(triangle_plane<ExactNumber>(g, a, b, c).at_eye);
  CHECK(truth == Sign::negative);
  for (const int mode : all_modes) {
    const RoundingMode guard(mode);
    const Ball at_eye = triangle_plane<Ball>(g, a, b, c).at_eye;
    CHECK(at_eye.radius == infinity);
    CHECK_FALSE(certain_sign(at_eye));
  }
}

TEST_CASE("ball: infinity and NaN never make a sign certain") {
  for (const int mode : all_modes) {
    const RoundingMode guard(mode);
    for (const Ball& unknown : {Ball(1, infinity), Ball(1, nan), Ball(nan, 0), Ball(infinity, 0),
                                Ball(nan, nan), Ball(0, infinity), Ball(largest_number, largest_number)}) {
      CHECK(unknown.radius == infinity);
      for (const Ball& other : {Ball(0), Ball(1), Ball(-1e300), Ball(1e-300), unknown}) {
        for (const Ball& b : {unknown + other, other - unknown, unknown * other, other * unknown, -unknown}) {
          CHECK(b.radius == infinity);
          CHECK_FALSE(certain_sign(b));
        }
      }
      for (const Vec3<Ball>& v :
           {Vec3<Ball>{unknown, 1, 1}, Vec3<Ball>{1, unknown, 1}, Vec3<Ball>{1, 1, unknown}}) {
        const Approx a = approximate(v);
        CHECK(a.radius == infinity);
        for (const Approx& known :
             {approximate({1, 2, 3}, 0), approximate({0, 0, 0}, 0), approximate({0, 0, 0}, 1)}) {
          CHECK(cross(a, known).radius == infinity);
          CHECK(cross(known, a).radius == infinity);
          for (const FilteredValue& f :
               {evaluate(a, prepare(known)), evaluate(known, prepare(a)), evaluate(a, prepare(a))})
            CHECK_FALSE(certain_sign(f.value, f.bound));
        }
      }
    }
  }
}

TEST_CASE("approx: vectors beyond the size bound are unknown, those below it are decided") {
  const Approx large = approximate({size_bound, 1, 1}, 0), fine = approximate({size_bound / 2, 1, 1}, 0);
  CHECK(large.radius == infinity);
  CHECK(fine.radius == 0);
  CHECK(approximate({1, 1, 1}, size_bound).radius == infinity);
  const FilteredValue f = evaluate(fine, prepare(fine));
  CHECK(certain_sign(f.value, f.bound) == Sign::positive);
}

TEST_CASE("approx: an error lost to underflow in the prepared bound is paid for") {
  // Rounded to nearest, nine half-ulps of so small a size are zero; the products are not that exact.
  for (const int mode : all_modes) {
    const RoundingMode guard(mode);
    const ApproxDirection tiny = prepare(approximate({0x1p-1030, 0x1.8p-1030, -0x1.4p-1030}, 0));
    const Approx huge = approximate({0x1.fp399, 0x1.5p399, 0x1.3p399}, 0);
    CHECK(evaluate(huge, tiny).bound >= underflow_bound);
    CHECK(evaluate(huge, tiny).bound >= 9 * 0x1p-53 * 0x1p399 * 0x1p-1030);
  }
}

}  // namespace provis::test
