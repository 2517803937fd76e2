#pragma once
// What is visible along a segment, at the centres of the pixels (R10).

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "provis/arithmetic.hpp"
#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// A camera that translates without turning: at t in [0, 1] its eye is from + t (to - from).
struct SegmentView {
  Vec3d from, to;             ///< may be equal: then every t is the same point
  std::vector<Frame> frames;  ///< pinhole frames, one or more
  PixelGrid pixels;           ///< of each frame; its centres are the directions (R8)
};

/// A part of the camera's path on which one set of primitives is visible at a pixel's centre.
struct Sight {
  std::string from, to;              ///< t where it begins and ends: "p/q" in lowest terms, q > 0
  std::vector<PrimitiveId> visible;  ///< ascending; empty where there is background only
};

/// All that is visible at one pixel's centre. The sights have positive length, follow one another, fill
/// [0, 1], and no two neighbours show the same set: the list is unique.
struct PixelSights {
  int frame = 0, column = 0, row = 0;  ///< row 0 on top
  std::vector<Sight> sights;
};

/// All pixels of one row of one frame.
struct PixelRow {
  int frame = 0, row = 0;  ///< row 0 on top
};

/// Which algorithm answers. The sets are the same.
enum class SegmentEngine {
  fast,   ///< the default: skips what is certainly hidden
  plain,  ///< Popescu et al.: every triangle against every frame; a baseline
};

struct SegmentOptions {
  Arithmetic arithmetic = Arithmetic::chain;
  SegmentEngine engine = SegmentEngine::fast;
  std::optional<PixelRow> only;  ///< where given, the query is about the centres of these pixels alone
  bool witnesses = false;        ///< one canonical witness for each primitive of R10°
  std::uint64_t memory_bytes =
      0;  ///< what the lists may take before the segment is cut in two; 0 has no bound
  /// Where given: called with every pixel in order of frame, row and column, from one thread at a time.
  std::function<void(const PixelSights&)> on_pixel;
};

/// How much is seen of one primitive: a measure of its importance.
struct Seen {
  PrimitiveId primitive = 0;
  std::uint64_t pixels = 0;  ///< pixels at whose centre it is visible for some time
  double length = 0;  ///< sum over those pixels of the visible share of [0, 1], rounded: shares to 2^-30,
                      ///< their sum to float64
};

/// The answer along one segment.
struct SegmentSet {
  VisibleSet set;                     ///< answers R10; witnesses for the primitives of R10° only
  std::vector<PrimitiveId> boundary;  ///< visible, but not in R10°: no proof of R9; ascending
  std::vector<Seen> seen;             ///< one per visible primitive, in id order
};

/// Which primitives are visible at a pixel's centre while the camera translates along a segment.
///
/// Input:      scene: F triangles; view: segment and frames in world units
/// Returns:    status per primitive, size F; how much is seen of each; lists and witnesses where asked for
/// Guarantee:  exact (R10); with Arithmetic::doubles none (Guarantee::sampled)
/// Error:      none: float64 coordinates are taken as exact, events are rational
/// Requires:   check(view) passes
/// Degenerate: hits are closed, so both neighbours of an edge are visible where a pixel's plane holds the
///             edge; a single event is no interval; coincident triangles are all visible; a triangle whose
///             plane holds the segment is hidden and hides nothing; a segment of length zero answers the
///             point query at the pixel centres
/// Throws:     Error::cancelled, Error::usage (witnesses asked of plain doubles, a row that is not there),
///             Error::unsupported (spheres), Error::internal
/// Source:     V. Popescu, E. Sacks, Z. Zhang, J. Vazquez, Complex VEs on All-In-One VR Headsets Through
///             Continuous From-Segment Visibility Computation
SegmentSet visible_from_segment(const Scene& scene, const SegmentView& view,
                                const SegmentOptions& options = {}, const Context& context = {});

/// Which primitives are seen at a pixel's centre from single viewpoints along a segment, by a z-buffer in
/// float64: what is done where the continuous answer is not to be had, for comparison.
///
/// Input:      viewpoints: one or more, in the middles of as many equal parts of the segment
/// Returns:    status per primitive, size F; all visible ones are boundary: nothing is proven; no `seen`
/// Guarantee:  none (Guarantee::sampled): misses what is seen between viewpoints only; what is farther by
///             less than a part in 2^30 is not hidden, so that coincident triangles are all found
/// Requires:   check(view) passes
/// Throws:     Error::cancelled, Error::usage (no viewpoint), Error::unsupported (spheres)
/// Cost:       linear in the viewpoints; parallel; same answer for any thread count
SegmentSet sampled_along_segment(const Scene& scene, const SegmentView& view, int viewpoints,
                                 const Context& context = {});

/// Throws Error::usage unless every number is finite, every window has positive extent, the vectors of each
/// frame are linearly independent (decided exactly), and pixels are 1 to 16384 each way.
void check(const SegmentView& view);

}  // namespace provis
