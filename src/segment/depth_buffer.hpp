#pragma once
// What one viewpoint sees at the pixel centres of one frame: a z-buffer in plain float64, as fast as it is
// simple. Nothing that it says is certain.

#include <array>
#include <optional>
#include <vector>

#include "predicates/path.hpp"
#include "src/segment/block.hpp"
#include "src/segment/cluster_tree.hpp"

namespace provis {

/// A triangle in homogeneous pixel coordinates, in which the centre of a pixel is (column, row, 1). Nothing
/// is divided by a distance, so no triangle has to be clipped.
struct Silhouette {
  std::array<Vec3d, 3> edges;  ///< all three are >= 0 where the triangle is hit
  Vec3d nearness;              ///< 1 / distance there
  double nearest = HUGE_VAL;   ///< no hit has more
  PixelRect box;               ///< of all hits; not empty
};

/// A viewpoint with a frame.
class PixelView {
 public:
  PixelView(const Vec3d& eye, const Frame& frame, const PixelGrid& pixels);

  const PixelGrid& pixels() const { return pixels_; }

  /// Nothing where the triangle has no area here, shows a side that it does not have, or lies beside the
  /// frame.
  std::optional<Silhouette> silhouette(const Vec3d& a, const Vec3d& b, const Vec3d& c,
                                       bool single_sided) const;

  /// Whether the box lies beside the frame or behind the viewpoint.
  bool misses(const ClusterBox& box) const;

 private:
  Vec3d to_pixels(const Vec3d& p) const {
    const Vec3d q = p - eye_;
    return {dot(rows_[0], q), dot(rows_[1], q), dot(rows_[2], q)};
  }

  Vec3d eye_;
  PixelGrid pixels_;
  std::array<Vec3d, 3> rows_;
  std::array<Vec3d, 5> inward_;  ///< left, right, top, bottom, front
  double orientation_;           ///< sign of the map's determinant
};

/// The nearest occluders at all pixels.
class DepthBuffer {
 public:
  explicit DepthBuffer(const PixelGrid& pixels);

  void clear();
  void add(const Silhouette& s);
  /// Call it once all occluders are there.
  void finish();

  /// Whether the triangle is hit where no occluder is nearer, by more than rounding can explain.
  bool shows(const Silhouette& s) const;

 private:
  static constexpr int tile = 16;
  /// How much nearer an occluder has to be: coincident triangles differ by rounding alone.
  static constexpr double clearly = 1 + 0x1p-30;

  /// Whether all tiles that the triangle may be hit in are nearer throughout.
  bool behind_tiles(const Silhouette& s) const;
  template <class Use>
  bool scan(const Silhouette& s, const Use& use) const;

  PixelGrid pixels_;
  int tile_columns_;
  std::vector<double> nearness_, farthest_;  ///< by pixel; the least of each tile
};

}  // namespace provis
