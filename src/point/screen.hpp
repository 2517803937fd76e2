#pragma once
// Input points on a grid of cells over the window, in float32 with one certified margin: enough to say where
// a triangle certainly is not.

#include <cstdint>

#include "provis/view.hpp"
#include "src/point/frame_point.hpp"

namespace provis {

/// A square number of equal cells over a window. Cell (i, j) reaches from x(i) to x(i + 1), y(j) to y(j + 1).
struct WindowGrid {
  Window window;
  int side = 1;  ///< cells in each direction; a power of two

  double x(int i) const { return border(window.x0, window.x1, i); }
  double y(int j) const { return border(window.y0, window.y1, j); }

  /// The rectangle of cells [i, i + n) x [j, j + n).
  Window block(int i, int j, int n) const { return {x(i), x(i + n), y(j), y(j + n)}; }

 private:
  /// The window's own borders, whatever the extent: that of a very large window is infinite.
  double border(double first, double last, int k) const {
    return k == 0 ? first : k == side ? last : first + k * ((last - first) / side);
  }
};

/// Where a point certainly lies.
enum ScreenCode : std::uint32_t {
  beyond_left = 1,
  beyond_right = 2,
  beyond_bottom = 4,
  beyond_top = 8,
  behind_viewer = 16,
  beyond_any = 31,
  unplaced = 32,  ///< near the plane of the viewer, far outside, or out of range: no coordinates
};

/// Coordinates in cells, true within Screen::margin; depth grows towards the viewer and is not below the true
/// one, in the screen's unit.
struct ScreenPoint {
  float x, y, depth;
  std::uint32_t code;
};

/// The projection of one frame to a grid.
class Screen {
 public:
  static constexpr float margin = 1.0f / 64;

  /// unit: a length typical of the scene's distances; any gives valid answers.
  Screen(const ViewGeometry& geometry, const WindowGrid& grid, double unit);

  ScreenPoint project(const Vec3d& p) const;

  const FrameProjection& projection() const { return projection_; }

  /// Whether coordinates can be told apart at all: a window may be a few ulps wide.
  bool usable() const { return usable_; }

  /// A lower bound on the screen's depth, from one on the depth times at_eye; -infinity if there is none.
  float depth_bound(double lowest, const Ball& at_eye) const;

 private:
  static constexpr double farthest_cell = 1 << 14;

  float depth(const FramePoint& p) const;
  std::uint32_t code(const FramePoint& p) const;

  FrameProjection projection_;
  Window window_;
  double side_ = 1;
  double reach_ = 0;  ///< largest magnitude of a window coordinate
  double cells_per_x_ = 0, cells_per_y_ = 0;
  double tolerance_ = 0;  ///< in window coordinates
  double unit_ = 1;
  bool usable_ = false;
};

}  // namespace provis
