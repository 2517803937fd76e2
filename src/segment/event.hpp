#pragma once
// Moments at which something changes at a pixel's centre, and the part of the path on which a triangle is
// hit.

#include <cstdint>

#include "predicates/sign.hpp"
#include "src/segment/facet.hpp"

namespace provis {

enum class EventKind : std::uint8_t {
  edge_0,  ///< edge k of the facet passes the pixel's centre
  edge_1,
  edge_2,
  plane,     ///< the camera passes the facet's plane
  crossing,  ///< the planes of two facets cross on the ray
  time,      ///< a moment given as a number: an end of the path, or where it is cut in two
};

/// A moment: the root of a function that is linear in time.
struct Event {
  double t = 0, error = 0;  ///< within the error of the true one
  std::uint32_t facet = no_facet, other = no_facet;
  EventKind kind = EventKind::time;
  Sign slope = Sign::positive;  ///< of the function whose root it is
};

inline Event moment(double t) { return {t, 0, no_facet, no_facet, EventKind::time, Sign::positive}; }

/// A facet as one pixel sees it. Its distance at t is depth_at_zero - t depth_slope, within depth_error.
struct Shown {
  std::uint32_t facet = no_facet;
  Sign side = Sign::zero;  ///< of `along`
  bool on_edge = false;    ///< the pixel's plane holds one of its edges, so that no hit is an inner one
  double depth_at_zero = 0, depth_slope = 0, depth_error = HUGE_VAL;

  double depth(double t) const { return depth_at_zero - t * depth_slope; }
};

/// Where a facet is hit: from begin to end, which have a positive distance.
struct Span {
  Event begin, end;
  Shown shown;
};

/// The part of the path that is looked at.
struct TimeRange {
  double begin = 0, end = 1;
};

}  // namespace provis
