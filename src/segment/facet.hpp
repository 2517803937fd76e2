#pragma once
// A triangle prepared for one frame: all that a pixel needs of it, as float64 functions of window coordinates
// with certified errors.

#include <limits>

#include "predicates/path.hpp"
#include "provis/scene.hpp"
#include "src/point/window_function.hpp"

namespace provis {

inline constexpr std::uint32_t no_facet = std::numeric_limits<std::uint32_t>::max();

/// value(t) = at_zero - t slope at each pixel's centre.
struct MotionFunction {
  WindowFunction at_zero, slope;
};

struct MovingFacet {
  PrimitiveId id = 0;
  bool occludes = true, single_sided = false;
  Corners corners;
  /// Edge k leads from corner k to corner k + 1 or, where it is turned, back: every edge is computed from its
  /// smaller end to its larger one, so that both triangles at an edge have the same numbers for it.
  Corners edges[3];
  bool turned[3] = {false, false, false};
  MotionFunction edge[3];
  WindowFunction along;
  Ball reach_at_zero, reach_slope;
};

/// What functions of window coordinates lose because a pixel's centre is rounded too: it is off by 4 u of the
/// window's extent each way (ERRORS.md, 9).
MovingFacet make_facet(const Scene& scene, PrimitiveId id, const PathGeometry& path);

/// Whether the facet certainly has no hit at any centre inside the window while t is in [begin, end]: it
/// shows a side that it does not have, or all of them pass one of its edges outside.
bool misses(const MovingFacet& f, const Window& w, double begin, double end);

/// A pixel's centre, each coordinate off by at most 4 u of the window's extent.
struct Centre {
  double x, y;
};
Centre pixel_centre(const PathGeometry& path, const Pixel& at);

}  // namespace provis
