#pragma once
// One triangle as it is seen through one frame: where it is hit, how near, and whether it occludes.

#include <optional>
#include <vector>

#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/window_polygon.hpp"

namespace provis::test {

/// A triangle that rays of the window hit, and that is not seen from a culled side.
struct Facet {
  PrimitiveId id = 0;
  bool occludes = false;
  std::vector<Line> inside;  ///< the triangle is hit where all of these are positive
  WindowPolygon polygon;     ///< the window clipped by these lines

  /// nearness / denominator at (x, y, 1) grows as the hit comes nearer: 1/distance for a finite eye, minus
  /// the distance for an eye at infinity. Both are linear on the window, which makes comparing them a line.
  Integer3 nearness;
  Integer denominator;  ///< > 0
  Bounds nearness_bounds{};
};

/// A frame of a view, in integers.
class FrameView {
 public:
  FrameView(const PointView& view, const Frame& frame, const CommonScale& scale);

  /// Nothing where the window's rays do not hit triangle t in positive area, or hit only a culled side.
  std::optional<Facet> facet(const SceneArrays& scene, std::size_t t) const;

  /// The ray through the window's point (x, y, w), w a power of two.
  Witness ray_through(const Integer3& point, PrimitiveId id) const;

 private:
  struct Corners {
    Integer3 a, b, c;  // seen from the eye
  };

  std::optional<Facet> pinhole_facet(const Corners& at, bool& from_front) const;
  std::optional<Facet> parallel_facet(const Corners& at, bool& from_front) const;

  /// The function m . (x right + y up) + constant.
  Integer3 on_window(const Integer3& m, const Integer& constant) const;

  const CommonScale scale_;
  bool parallel_;
  Integer3 eye_, right_, up_, forward_;
  WindowPolygon window_;
};

}  // namespace provis::test
