#pragma once
// Far bounds: for a part of the path, how far a hit can be and still be seen, at a pixel and in a whole
// block.

#include <algorithm>
#include <array>
#include <vector>

#include "src/segment/block.hpp"
#include "src/segment/frustum.hpp"

namespace provis {

class Hiding {
 public:
  Hiding(const PathProjection& projection, const PathGeometry& path, const Frustum& frustum,
         const PixelRect& area);

  /// Whether everything at least so far (Frustum::nearest) lies behind an occluder in all of these parts, at
  /// every pixel of the block.
  bool hides(double nearest, const PartRange& parts) const { return beyond(block_, nearest, parts); }

  /// The same at one pixel.
  bool hides_at(std::size_t pixel, double nearest, const PartRange& parts) const {
    return beyond(pixels_[pixel], nearest, parts);
  }

  /// Whether a facet is hidden at a pixel wherever it is hit.
  bool hides_at(std::size_t pixel, const Span& span) const;

  void changed(std::size_t pixel) { changed_[pixel] = 1; }

  /// Takes from the envelopes what they hide by now.
  template <Arithmetic A>
  void refresh(const Block<A>& block) {
    block_.fill(-HUGE_VAL);
    for (std::size_t k = 0; k < pixels_.size(); ++k) {
      if (changed_[k]) bound(block.envelope(k), pixels_[k]);
      changed_[k] = 0;
      for (std::size_t p = 0; p < block_.size(); ++p) block_[p] = std::max(block_[p], pixels_[k][p]);
    }
  }

 private:
  using Bounds = std::array<double, Frustum::parts>;

  static bool beyond(const Bounds& bounds, double nearest, const PartRange& parts) {
    for (int p = parts.first; p <= parts.last; ++p)
      if (!(nearest > bounds[static_cast<std::size_t>(p)])) return false;
    return true;
  }

  void bound(const Envelope& envelope, Bounds& bounds) const;
  /// Bounds on the product of a hit with the row of distance.
  double farthest(const Shown& s, double t) const;
  double nearest(const Shown& s, double t) const;
  int part_of(double t) const;

  const Frustum& frustum_;
  double viewpoint_at_zero_, viewpoint_slope_;  ///< product of the viewpoint with the row of distance
  double determinant_, skew_, margin_;
  double parts_per_time_;
  Bounds block_;
  std::vector<Bounds> pixels_;
  std::vector<std::uint8_t> changed_;  ///< since the last refresh
};

}  // namespace provis
