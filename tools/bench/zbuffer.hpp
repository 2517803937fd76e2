#pragma once
// A z-buffer in float64 on one thread: what merely drawing the scene costs. The yardstick of the benchmark.

#include <cstdint>
#include <limits>
#include <vector>

#include "provis/scene.hpp"
#include "provis/view.hpp"

namespace provis::bench {

/// Nearest triangle at each pixel's centre, by rounded arithmetic.
class ZBuffer {
 public:
  ZBuffer(int width, int height);

  /// Draws all triangles of the scene, two-sided and opaque, through the view's first frame (pinhole).
  void draw(const Scene& scene, const PointView& view);

  /// One flag per triangle: whether it is nearest at some pixel.
  std::vector<std::uint8_t> seen(std::size_t triangles) const;

  /// What is nearest at each pixel, row by row from the top.
  const std::vector<std::uint32_t>& ids() const { return id_; }
  static constexpr std::uint32_t nothing = std::numeric_limits<std::uint32_t>::max();

  /// Whole numbers from first to last.
  struct Span {
    int first, last;

    bool empty() const { return first > last; }
  };

 private:
  /// In pixels, centres at whole numbers; inverse is 1 / depth, linear on the image, and negative behind the
  /// eye.
  struct Projected {
    double x, y, inverse;
  };
  /// The same before the division.
  using Homogeneous = Vec3d;

  void set_view(const PointView& view);
  Homogeneous transform(const Vec3d& p) const;
  static Projected divide(const Homogeneous& h) { return {h.x / h.z, h.y / h.z, 1 / h.z}; }
  void add(const Projected& a, const Projected& b, const Projected& c, std::uint32_t id);
  void add_clipped(const Vec3d& a, const Vec3d& b, const Vec3d& c, std::uint32_t id);

  int width_, height_;
  Vec3d eye_, row_x_, row_y_, row_depth_;
  std::vector<double> inverse_depth_;
  std::vector<std::uint32_t> id_;
};

}  // namespace provis::bench
