#pragma once
// What is visible from a point.

#include "provis/arithmetic.hpp"
#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// How the set is found.
enum class Method {
  exact,       ///< decides every primitive
  aggressive,  ///< finds every primitive with a fragment that is completely visible; proves what it finds
  sampled,     ///< looks along a regular grid of rays; proves what it finds and promises no more
};

/// Which algorithm answers Method::exact. The sets are the same.
enum class PointEngine {
  fast,   ///< the default
  paper,  ///< Popescu et al.: aggressive set, subdivision of what is visible, classify, sample again
};

struct PointOptions {
  Arithmetic arithmetic = Arithmetic::chain;
  Method method = Method::exact;
  PointEngine engine = PointEngine::fast;
  PixelGrid pixels;          ///< Method::aggressive, Method::sampled: 1 to 16384 each way
  int samples = 1;           ///< Method::sampled: samples^2 rays in each pixel, 1 to 256
  bool witnesses = false;    ///< one canonical witness per visible primitive (verify_witnesses checks them)
  bool subdivision = false;  ///< the planar subdivision with exact areas
};

/// Which primitives are visible from a point within a window.
///
/// Input:      scene: F triangles; view: eye and frames in world units
/// Returns:    status per primitive, size F; witnesses and cells where asked for
/// Guarantee:  exact (R7); aggressive for the other methods, which leave undecided what they do not find:
///             Method::aggressive finds every primitive that has, in some pixel, a fragment in which no
///             occluder is nearer; with Arithmetic::doubles none (Guarantee::sampled)
/// Error:      none: float64 coordinates are taken as exact
/// Requires:   check(view) passes
/// Degenerate: edge contact is no leak; coincident triangles are all visible; a triangle whose plane
///             holds the eye is hidden and hides nothing
/// Throws:     Error::cancelled, Error::usage (witnesses or cells asked of plain doubles, cells of a method
///             that is not exact, pixels or samples out of range), Error::unsupported (spheres; witnesses of
///             Method::sampled for an eye at infinity), Error::internal
/// Cost:       about O(F log F + k l), k triangles per leaf in l leaves; parallel; same answer for any
///             thread count
/// Source:     V. Popescu, E. Sacks, Z. Cui, R. Ashok, from-point triangle visibility: the problem;
///             J. Warnock, A hidden surface algorithm for computer generated halftone pictures, 1969
VisibleSet visible_from_point(const Scene& scene, const PointView& view, const PointOptions& options = {},
                              const Context& context = {});

}  // namespace provis
