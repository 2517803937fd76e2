#pragma once
// Edges cut at the vertices that lie on them, so that triangles share edges across T-junctions too.

#include <cstdint>
#include <span>
#include <vector>

#include "provis/scene.hpp"

namespace provis::offset {

/// A scene's edges as chains of vertices. Equal positions are one vertex.
class Seams {
 public:
  /// Guarantee:  exact: an edge is cut at every vertex of the scene that lies strictly inside it
  explicit Seams(const Scene& scene);

  std::uint32_t vertex(std::uint32_t index) const { return welded_[index]; }
  const Vec3d& position(std::uint32_t vertex) const { return *positions_[vertex]; }

  /// The vertices inside the edge from corner k of the triangle to the next, on the way from the smaller
  /// vertex number to the larger.
  std::span<const std::uint32_t> inside(std::size_t triangle, std::size_t k) const {
    const std::uint32_t e = edge_of_[3 * triangle + k];
    return {inside_.data() + first_[e], first_[e + 1] - first_[e]};
  }

 private:
  std::vector<std::uint32_t> welded_;          ///< by index of the scene's vertices
  std::vector<const Vec3d*> positions_;        ///< by vertex
  std::vector<std::uint32_t> edge_of_;         ///< by triangle and corner
  std::vector<std::uint32_t> first_, inside_;  ///< by edge
};

}  // namespace provis::offset
