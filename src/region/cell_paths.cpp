#include "src/region/cell_paths.hpp"

#include <algorithm>

namespace provis {

std::vector<std::pair<Vec3d, Vec3d>> edges_and_diagonals(const ViewCell& cell) {
  const auto corner = [&](unsigned k) {
    return Vec3d{(k & 1 ? cell.upper : cell.lower).x, (k & 2 ? cell.upper : cell.lower).y,
                 (k & 4 ? cell.upper : cell.lower).z};
  };
  std::vector<std::pair<Vec3d, Vec3d>> paths;
  const auto add = [&](unsigned from, unsigned to) {
    const std::pair path(corner(from), corner(to)), back(path.second, path.first);
    // Of a flat cell several are the same.
    const bool known =
        std::any_of(paths.begin(), paths.end(), [&](const auto& p) { return p == path || p == back; });
    if (path.first != path.second && !known) paths.push_back(path);
  };
  for (const unsigned axis : {1u, 2u, 4u})
    for (unsigned k = 0; k < 8; ++k)
      if (!(k & axis)) add(k, k | axis);
  for (const unsigned k : {0u, 1u, 2u, 4u}) add(k, 7 - k);
  return paths;
}

}  // namespace provis
