#pragma once
// A wavy grid of triangles, for tests that compress geometry and look at what comes back.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "provis/scene.hpp"

namespace provis {

/// side * side vertices, two triangles in every cell.
struct Grid {
  std::vector<float> coordinates;
  std::vector<unsigned> indices;

  explicit Grid(unsigned side) {
    for (unsigned i = 0; i < side; ++i)
      for (unsigned j = 0; j < side; ++j)
        for (const unsigned k : {8 * i, 8 * j, (i * i + 3 * j) % 7})
          coordinates.push_back(static_cast<float>(k) / 8);
    for (unsigned i = 0; i + 1 < side; ++i)
      for (unsigned j = 0; j + 1 < side; ++j) {
        const unsigned a = i * side + j, b = a + side;
        indices.insert(indices.end(), {a, b, a + 1, b, b + 1, a + 1});
      }
  }

  std::size_t vertex_count() const { return coordinates.size() / 3; }

  std::vector<Vec3d> vertices() const {
    std::vector<Vec3d> all;
    for (std::size_t i = 0; i < coordinates.size(); i += 3)
      all.push_back({coordinates[i], coordinates[i + 1], coordinates[i + 2]});
    return all;
  }

  std::vector<Triangle> triangles() const {
    std::vector<Triangle> all;
    for (std::size_t i = 0; i < indices.size(); i += 3)
      all.push_back({indices[i], indices[i + 1], indices[i + 2]});
    return all;
  }
};

/// Every triangle from its smallest corner on.
inline std::vector<Triangle> turned(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::rotate(t.begin(), std::ranges::min_element(t), t.end());
  return triangles;
}

}  // namespace provis
