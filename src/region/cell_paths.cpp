#include "src/region/cell_paths.hpp"

#include <algorithm>

#include "src/scene/box_tree.hpp"

namespace provis {

std::vector<std::pair<Vec3d, Vec3d>> edges_and_diagonals(const ViewCell& cell) {
  const auto corners = corners_of(Box{cell.lower, cell.upper});
  std::vector<std::pair<Vec3d, Vec3d>> paths;
  const auto add = [&](unsigned from, unsigned to) {
    const std::pair path(corners[from], corners[to]), back(path.second, path.first);
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
