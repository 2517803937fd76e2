// The sign of a determinant, decided exactly.
#include <catch2/catch.hpp>
#include <cmath>

#include "src/scene/placement.hpp"

namespace provis {
namespace {

Placement with_rows(std::array<double, 3> a, std::array<double, 3> b, std::array<double, 3> c) {
  Placement m;
  for (std::size_t j = 0; j < 3; ++j) {
    m.rows[0][j] = a[j];
    m.rows[1][j] = b[j];
    m.rows[2][j] = c[j];
  }
  return m;
}

TEST_CASE("the determinant's sign is exact where float64 sees zero or the wrong sign") {
  // Rows (1, 1, 1), (1, 1 + e, 1), (1, 1, 1 + f): the determinant is e f.
  const double e = std::ldexp(1.0, -52);
  CHECK(determinant_sign(with_rows({1, 1, 1}, {1, 1 + e, 1}, {1, 1, 1 + e})) == Sign::positive);
  CHECK(determinant_sign(with_rows({1, 1, 1}, {1, 1 - e, 1}, {1, 1, 1 + e})) == Sign::negative);
  CHECK(determinant_sign(with_rows({0.1, 0.2, 0.3}, {0.2, 0.4, 0.6}, {1, 0, 7})) == Sign::zero);
}

TEST_CASE("the determinant's sign survives underflow and overflow") {
  const double tiny = 5e-324, huge = 1e308;
  CHECK(determinant_sign(with_rows({tiny, 0, 0}, {0, tiny, 0}, {0, 0, -tiny})) == Sign::negative);
  CHECK(determinant_sign(with_rows({huge, 0, 0}, {0, huge, 0}, {0, 0, huge})) == Sign::positive);
  CHECK(determinant_sign(with_rows({huge, huge, 0}, {huge, huge, tiny}, {0, tiny, 0})) == Sign::negative);
}

TEST_CASE("placing a point rounds every product and sum once") {
  Placement m;
  m.rows[0] = {0.1, 0.2, 0.3, 0.4};
  const Vec3d p{1.1, 2.2, 3.3};
  CHECK(apply(m, p).x == ((0.1 * p.x + 0.2 * p.y) + 0.3 * p.z) + 0.4);
  CHECK(apply(compose(m, Placement{}), p) == apply(m, p));
  CHECK(apply(compose(Placement{}, m), p) == apply(m, p));
}

}  // namespace
}  // namespace provis
