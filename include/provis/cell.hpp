#pragma once
// What is visible from a box: the camera may be anywhere in a view cell.

#include <cstdint>
#include <optional>

#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis {

/// An axis-parallel box of viewpoints, and the directions in which is looked from them.
struct ViewCell {
  Vec3d lower, upper;  ///< taken as exact; where coordinates are equal the box is flat, thin or a point
  std::optional<Frame> window;  ///< directions forward + x right + y up; the whole sphere where there is none
};

/// The box with the given center and lengths of its edges: corners are computed once, in float64, and are
/// exact from there on.
///
/// Guarantee:  none needed: the corners are recorded in the result
/// Degenerate: an edge of length zero is allowed
ViewCell cell_around(const Vec3d& center, const Vec3d& edges);

/// Throws Error::usage unless every number is finite, no lower coordinate is above its upper one, and the
/// window passes check(PointView).
void check(const ViewCell& cell);

class LevelOfDetail;

/// What is computed.
enum class CellMethod {
  bounds,     ///< both bounds of R9: the lower set by sampling viewpoints and directions, the upper set for
              ///< what is left
  lower,      ///< only what is proven to be visible
  cos,        ///< only what is not proven to be hidden: the camera offset space of the paper, alone
  cos_exact,  ///< another question (R10): what the samples of the camera offset space show, exactly
};

struct CellOptions {
  CellMethod method = CellMethod::bounds;
  PixelGrid pixels{200, 100};  ///< of each raster of a face's hemicube; 1 to 1024 each way. cos_exact: one
                               ///< sample in the centre of each, so that 32x32 are many
  int refinements = 8;         ///< halvings of a pixel's rays where a triangle is left undecided, 0 to 32
  int viewpoints = 32;   ///< lower set: exact sets from so many points besides corners and centre, 0 to 65536
  int directions = 4;    ///< lower set: directions^2 exact samples of the offset space per face, 0 to 256
  int path_pixels = 16;  ///< lower set: along edges and diagonals, pixels each way of each frame, 0 to 1024
  int rays = 64;  ///< bounds: random rays aimed at each primitive that is undecided after all else, 0 to 10^6
  std::uint64_t seed = 1;  ///< of the viewpoints and rays
  /// bounds and cos: the upper set is found with it instead of the scene itself. Of this very scene; outlives
  /// the query
  const LevelOfDetail* detail = nullptr;
};

/// How the camera offset space was resolved. Lists are those of the pixels that were reached: a part of a
/// raster in which nothing was left to decide has none.
struct OffsetStats {
  std::uint64_t rasters = 0;          ///< of all faces
  std::uint64_t beams = 0;            ///< rectangles of pixels that were looked at
  std::uint64_t lists = 0;            ///< pixels with a list
  std::uint64_t list_entries = 0;     ///< of all lists
  std::uint64_t list_most = 0;        ///< entries of the longest list
  std::uint64_t early_hidden = 0;     ///< entries that lie behind what covers their whole beam
  std::uint64_t resolved = 0;         ///< entries that were held against fused occluders
  std::uint64_t resolved_hidden = 0;  ///< of these, proven to be hidden in their pixel
  std::uint64_t refined = 0;          ///< parts of pixels that were looked at
  // Triangles kept in a raster, by what stood in the way of the first fused occluder:
  std::uint64_t kept_seen = 0;             ///< one ray certainly meets nothing before it
  std::uint64_t kept_nothing_between = 0;  ///< there was none
  std::uint64_t kept_open_edge = 0;        ///< a silhouette or a gap
  std::uint64_t kept_unusable = 0;         ///< it pierces the triangle, or may come after it
  std::uint64_t kept_too_many = 0;         ///< more than 256 occluders
  std::uint64_t facing_unknown = 0;  ///< triangles whose plane crosses a face: they do not occlude from there
  std::uint64_t signs_interval = 0, signs_exact = 0;  ///< signs between input points, by what decided them
  // Of all threads:
  double seconds_build = 0;    ///< seams, triangles and edges before each face
  double seconds_lists = 0;    ///< cutting triangles to beams, ordering them
  double seconds_early_z = 0;  ///< covers of whole beams
  double seconds_resolve = 0;  ///< triangles against fused occluders

  double list_average() const;

  OffsetStats& operator+=(const OffsetStats& other);
};

/// How many primitives each stage added to the lower set, in this order, and what is undecided.
struct BoundStats {
  std::uint64_t touching = 0;    ///< visible because they meet the cell (R9)
  std::uint64_t viewpoints = 0;  ///< from sampled viewpoints
  std::uint64_t paths = 0;       ///< along edges and diagonals of the cell (R10°)
  std::uint64_t samples = 0;     ///< at samples of the camera offset space (R10°)
  std::uint64_t rays = 0;        ///< by random rays, after all else
  std::uint64_t boundary = 0;    ///< shown by samples (R10) without a proof
  std::uint64_t undecided = 0;   ///< in the upper set only
  std::uint64_t hidden = 0;
  std::uint64_t unwitnessed = 0;  ///< of `touching`: visible by rule, and no witness was found
  std::uint64_t viewpoints_used = 0, paths_used = 0, samples_used = 0;
  // Wall clock:
  double seconds_viewpoints = 0, seconds_paths = 0, seconds_samples = 0, seconds_upper = 0, seconds_rays = 0;
};

/// What a level of detail did; zero without one. All objects but the candidates are hidden.
struct DetailStats {
  std::uint64_t objects = 0;
  std::uint64_t candidates = 0;  ///< objects that are not proven hidden
  std::uint64_t whole = 0;       ///< of these, those whose shell may hold a part of the cell
  std::uint64_t dropped = 0;     ///< objects that hide nothing, because the cell may reach into them
  std::uint64_t triangles = 0;   ///< of the scene that was looked at instead of the full one
  double seconds_verification = 0;
};

/// The answer for one cell. Visible: the lower set. Hidden: everything outside the upper set.
struct CellSet {
  /// Answers R9 (cos_exact: R10); a witness for each visible primitive but those listed here.
  VisibleSet set;
  std::vector<PrimitiveId> unwitnessed;  ///< visible because they meet the cell; ascending
  std::vector<PrimitiveId> boundary;  ///< cos_exact: visible by R10, but not proven to be in R10°; ascending
  BoundStats bounds;
  OffsetStats offset;
  DetailStats detail;
};

/// Which primitives are visible from somewhere in a box, as a lower and an upper set.
///
/// Input:      scene: F triangles; cell: a box in world units
/// Returns:    status per primitive, size F
/// Guarantee:  bounds (R9): what is visible has a witness, what is hidden is proven hidden; aggressive for
///             CellMethod::lower, conservative for CellMethod::cos (which still calls visible what meets
///             the cell); exact where nothing is left undecided. CellMethod::cos_exact is exact for R10: what
///             is visible along the direction through the centre of a pixel, of any raster of any face, from
///             an open set of the face's points
/// Error:      none: float64 coordinates are taken as exact
/// Requires:   check(cell) passes; options.detail, where there is one, and its scenes are alive
/// Degenerate: triangles that meet the cell's interior, or overlap a face, are visible from the side they
///             have; coincident triangles are all visible; a cell of one point answers as visible_from_point.
///             cos_exact: only what lies beyond a face counts, and an occluder in its plane hides nothing
///             (R6); what is shown from there alone is `boundary`
/// Throws:     Error::cancelled, Error::usage (options out of range), Error::unsupported (spheres; a flat
///             cell without a viewpoint that lies on no occluder; cos_exact of a cell without a face of
///             some area); Error::usage for a level of detail of another scene, or with another method
/// Cost:       upper set: about O(pixels l^2), l entries per list; parallel; same answer for any thread count
/// Source:     J. Hladky, H.-P. Seidel, M. Steinberger, The camera offset space: real-time potentially
///             visible set computations for streaming rendering, 2019
CellSet visible_from_cell(const Scene& scene, const ViewCell& cell, const CellOptions& options = {},
                          const Context& context = {});

/// Which primitives are seen at a pixel's centre from a regular grid of viewpoints in the cell, its corners
/// among them, by a z-buffer in float64: what is done where bounds are not to be had, for comparison.
///
/// Input:      per_axis: per_axis^3 viewpoints, 1 to 100 along each axis; pixels: of each frame
/// Returns:    visible or hidden per primitive, size F; no witnesses
/// Guarantee:  none (Guarantee::sampled): misses what is seen between pixels and viewpoints only, and tells
///             nothing apart that differs by less than rounding; no rule of R9 for what meets the cell
/// Requires:   check(cell) passes
/// Throws:     Error::cancelled, Error::usage (grid or pixels out of range), Error::unsupported (spheres)
/// Cost:       linear in the viewpoints; parallel; same answer for any thread count
CellSet sampled_from_cell(const Scene& scene, const ViewCell& cell, int per_axis, const PixelGrid& pixels,
                          const Context& context = {});

}  // namespace provis
