#pragma once
// Queries along a segment on purpose degenerate: scenes of the generator's families, and segments that run in
// planes, along edges, along rays and through everything.

#include <cstdint>
#include <string>

#include "provis/segment.hpp"
#include "tests/support/case.hpp"

namespace provis::test {

/// A from-segment query to be answered by the engine and by the oracle.
struct SegmentCase {
  Case start;        ///< the scene, and the view from where the segment begins; pinhole frames
  Vec3d to;          ///< where it ends
  PixelGrid pixels;  ///< few: every pixel's centre is looked along exactly

  SegmentView view() const { return {start.view.eye, to, start.view.frames, pixels}; }
};

/// A case whose scene, segment, frames and pixels are functions of the seed, the same on every machine.
///
/// Guarantee: finite coordinates; windows of positive extent; linearly independent frame vectors; 1 to 30
///            pixels a frame
SegmentCase generate_segment(std::uint64_t seed);

/// Everything needed to replay a case: the text form of scene and view, then segment and pixels.
std::string describe(const SegmentCase& c);

}  // namespace provis::test
