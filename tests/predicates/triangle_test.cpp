// zero_area and on_triangle against rationals.

#include <catch2/catch.hpp>

#include "predicates/on_triangle.hpp"
#include "predicates/zero_area.hpp"
#include "tests/predicates/near_degenerate.hpp"
#include "tests/predicates/reference.hpp"

namespace provis::test {
namespace {

bool reference_zero_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const RationalVector o = rational(a);
  return is_zero(cross_product(rational(b) - o, rational(c) - o));
}

/// Barycentric coordinates: p = a + s (b - a) + t (c - a) with s, t, 1 - s - t >= 0, by the normal equations.
bool reference_on_triangle(const Vec3d& p, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if (reference_zero_area(a, b, c)) return false;
  const RationalVector o = rational(a), u = rational(b) - o, v = rational(c) - o, q = rational(p) - o;
  const Rational uu = dot_product(u, u), uv = dot_product(u, v), vv = dot_product(v, v);
  const Rational qu = dot_product(q, u), qv = dot_product(q, v), d = uu * vv - uv * uv;
  const Rational s = (qu * vv - qv * uv) / d, t = (qv * uu - qu * uv) / d;
  for (std::size_t k = 0; k < 3; ++k)
    if (q[k] != s * u[k] + t * v[k]) return false;
  return s >= 0 && t >= 0 && s + t <= 1;
}

}  // namespace

TEST_CASE("zero area: three points of one line, whatever their scale") {
  CHECK(zero_area({0, 0, 0}, {0, 0, 0}, {1, 2, 3}));
  CHECK(zero_area({1, 1, 1}, {1, 1, 1}, {1, 1, 1}));
  CHECK(zero_area({1, 2, 3}, {2, 4, 6}, {-3, -6, -9}));
  CHECK(zero_area({0, 0, 0}, {0x1p-1074, 0, 0}, {0x1p1023, 0, 0}));
  CHECK(zero_area({0.0, 1, 2}, {-0.0, 1, 2}, {5, 5, 5}));
  CHECK_FALSE(zero_area({0, 0, 0}, {0x1p-1074, 0, 0}, {0, 0x1p-1074, 0}));
  CHECK_FALSE(zero_area({0, 0, 0}, {1, 1, 1}, {1, 1, 1 + 0x1p-52}));
  CHECK_FALSE(zero_area({0, 0, 0}, {0x1p1023, 0x1p1023, 0}, {-0x1p1023, -0x1p1023, 0x1p-1074}));
}

TEST_CASE("on triangle: corners, edges, inside, beside, above") {
  const Vec3d a{0, 0, 0}, b{4, 0, 0}, c{0, 4, 0};
  for (const Vec3d& p : {a, b, c, Vec3d{2, 0, 0}, Vec3d{2, 2, 0}, Vec3d{0, 1, 0}, Vec3d{1, 1, 0}}) {
    CAPTURE(p.x, p.y, p.z);
    CHECK(on_triangle(p, a, b, c));
    CHECK(on_triangle(p, c, b, a));
  }
  for (const Vec3d& p : {Vec3d{2, 2 + 0x1p-51, 0}, Vec3d{1, -0x1p-1074, 0}, Vec3d{1, 1, 0x1p-1074},
                         Vec3d{3, 3, 0}, Vec3d{5, 0, 0}}) {
    CAPTURE(p.x, p.y, p.z);
    CHECK_FALSE(on_triangle(p, a, b, c));
  }
  CHECK_FALSE(on_triangle({1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {2, 0, 0}));  // R3: zero area holds no point
}

TEST_CASE("zero area and on triangle agree with rationals") {
  for (const NearFamily family : families) DYNAMIC_SECTION(name(family)) {
      for (const std::uint64_t seed : seeds(family == NearFamily::extreme ? 20 : 100)) {
        INFO("PROVIS_SEED=" << seed);
        const auto& [a, b, c, d, e, f, p] = make_input(family, seed).points;
        CHECK(zero_area(a, b, c) == reference_zero_area(a, b, c));
        for (const Vec3d& q : {d, e, p, Vec3d{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2}})
          CHECK(on_triangle(q, a, b, c) == reference_on_triangle(q, a, b, c));
      }
    }
}

}  // namespace provis::test
