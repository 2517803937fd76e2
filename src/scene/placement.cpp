#include "src/scene/placement.hpp"

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

Sign determinant_sign(const Placement& m) {
  const auto row = [&m](std::size_t i) {
    return Vec3<ExactNumber>{m.rows[i][0], m.rows[i][1], m.rows[i][2]};
  };
  return sign_of(dot(row(0), cross(row(1), row(2))));
}

}  // namespace provis
