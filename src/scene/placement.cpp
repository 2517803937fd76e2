#include "src/scene/placement.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/exact_number.hpp"

namespace provis {

bool Placement::finite() const {
  for (const auto& row : rows)
    for (const double x : row)
      if (!std::isfinite(x)) return false;
  return true;
}

Placement from_trs(const std::vector<double>& translation, const std::vector<double>& rotation,
                   const std::vector<double>& scale) {
  Placement m;
  if (!rotation.empty()) {
    const double x = rotation[0], y = rotation[1], z = rotation[2], w = rotation[3];
    m.rows[0] = {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), 0};
    m.rows[1] = {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), 0};
    m.rows[2] = {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), 0};
  }
  for (std::size_t i = 0; i < 3; ++i) {
    if (!scale.empty())
      for (std::size_t j = 0; j < 3; ++j) m.rows[i][j] *= scale[j];
    if (!translation.empty()) m.rows[i][3] = translation[i];
  }
  return m;
}

Placement from_columns(const std::vector<double>& matrix) {
  Placement m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 4; ++j) m.rows[i][j] = matrix[4 * j + i];
  return m;
}

Placement compose(const Placement& parent, const Placement& local) {
  Placement world;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& p = parent.rows[i];
    for (std::size_t j = 0; j < 4; ++j) {
      const double linear = (p[0] * local.rows[0][j] + p[1] * local.rows[1][j]) + p[2] * local.rows[2][j];
      world.rows[i][j] = j == 3 ? linear + p[3] : linear;
    }
  }
  return world;
}

// A quaternion of length sqrt(1 + e) turns a unit vector into one of squared length within 4e of 1, and unit
// vectors at right angles into ones whose scalar product is within 2e of 0. Rounding its components to
// float32 makes e at most 2^-23 (2 times the sum of |q|, at most 2, times 2^-25), so two such rotations, one
// below the other, are still taken as rotations.
std::optional<double> uniform_scale(const Placement& m) {
  const auto product = [&m](std::size_t a, std::size_t b) {
    const auto& r = m.rows;
    return (r[0][a] * r[0][b] + r[1][a] * r[1][b]) + r[2][a] * r[2][b];
  };
  const double squares[] = {product(0, 0), product(1, 1), product(2, 2)};
  const auto [least, most] = std::ranges::minmax(squares);
  if (std::isinf(most)) return most;
  const double slack = most / (1 << 20);
  const bool even = most - least <= slack && std::abs(product(0, 1)) <= slack &&
                    std::abs(product(0, 2)) <= slack && std::abs(product(1, 2)) <= slack;
  return even ? std::optional(std::sqrt(squares[0])) : std::nullopt;
}

Sign determinant_sign(const Placement& m) {
  const auto row = [&m](std::size_t i) {
    return Vec3<ExactNumber>{m.rows[i][0], m.rows[i][1], m.rows[i][2]};
  };
  return sign_of(dot(row(0), cross(row(1), row(2))));
}

}  // namespace provis
