#pragma once
// The rays of a rectangle of pixels while the camera translates, with the path cut into equal parts: which of
// them a cluster can be hit in, and how near it can be.

#include <array>
#include <vector>

#include "src/segment/cluster_tree.hpp"
#include "src/segment/path_projection.hpp"

namespace provis {

/// Parts first to last of the path; none where first > last.
struct PartRange {
  int first = 0, last = -1;

  bool empty() const { return first > last; }
};

class Frustum {
 public:
  static constexpr int parts = 16;

  /// Of pixels of the projection's frame, over a range of time.
  Frustum(const PathProjection& projection, const PathGeometry& path, const PixelRect& area,
          const TimeRange& range);

  /// In which parts of the path something inside the box, or inside the triangle, may be hit.
  PartRange touched(const ClusterBox& box) const;
  PartRange touched(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;

  /// The product of a point with the row of distance, which orders hits on one ray whatever the time: a lower
  /// bound for all points inside.
  double nearest(const ClusterBox& box) const;
  double nearest(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;

  /// Where part k begins.
  double time(int k) const { return times_[static_cast<std::size_t>(k)]; }

 private:
  static constexpr int sides = 5;

  template <class Farthest>
  PartRange touched_by(const Farthest& farthest) const;

  std::array<Vec3d, sides> inward_;  ///< left, right, bottom, top, front
  /// The least product of a viewpoint of part k with the inward normal, less the margin.
  std::array<std::array<double, parts>, sides> least_;
  std::array<double, parts + 1> times_;
  double margin_;
};

}  // namespace provis
