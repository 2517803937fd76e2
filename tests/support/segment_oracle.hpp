#pragma once
// The oracle for a segment: visibility at pixel centres (R10) by listing every event, as plain as it can be.
// It shares no code with the engine. Triangles only: a scene with spheres is refused (std::logic_error).

#include <set>
#include <vector>

#include "provis/scene.hpp"
#include "provis/segment.hpp"
#include "tests/support/exact_hit.hpp"
#include "tests/support/pixel_ray.hpp"

namespace provis::test {

/// A mistake put into the oracle on purpose, to prove that the comparison would catch it.
enum class SegmentPlant {
  none,
  drop_an_occluder,     ///< between two events, the nearest occluder is forgotten
  flip_a_tie,           ///< a tied depth counts as nearer
  use_an_epsilon,       ///< events closer than 1e-9 are one event
  forget_camera_event,  ///< nothing happens where the camera crosses a triangle's plane
  forget_crossings,     ///< nothing happens where two triangles swap their order
};

/// A part of [0, 1] on which one set is visible at a pixel's centre.
struct ExactSight {
  Rational from, to;
  std::vector<PrimitiveId> visible;

  friend bool operator==(const ExactSight&, const ExactSight&) = default;
};

/// All that is visible at one pixel's centre: as PixelSights, in numbers that compare.
struct ExactSights {
  int frame = 0, column = 0, row = 0;
  std::vector<ExactSight> sights;

  friend bool operator==(const ExactSights&, const ExactSights&) = default;
};

struct ExactSeen {
  PrimitiveId primitive = 0;
  std::uint64_t pixels = 0;  ///< that show it
  std::uint64_t sights = 0;  ///< in which they do
  Rational length;
};

struct SegmentAnswer {
  std::vector<PrimitiveId> visible;   ///< R10, ascending
  std::vector<PrimitiveId> boundary;  ///< of these, the ones that are not in R10°; ascending
  std::vector<ExactSights> pixels;    ///< in order of frame, row and column
  std::vector<ExactSeen> seen;        ///< one per visible triangle, ascending
};

/// What one ray sees.
struct Look {
  std::vector<PrimitiveId> visible;  ///< closed hits that no occluder hides, ascending
  std::vector<PrimitiveId> proper;   ///< of these: hit inside, and each occluder as near lies in their plane
  Rational nearest;  ///< distance of the nearest occluder, in world units over a multiple of the direction;
                     ///< the same multiple for each scene seen through a pixel. 0 where there is none
};

/// One scene and one segment, to be asked pixel by pixel.
class SegmentOracle {
 public:
  SegmentOracle(const SceneArrays& scene, const SegmentView& view, SegmentPlant plant = SegmentPlant::none);

  /// 0, 1, and every t between them at which anything may change along the pixel's centre; ascending.
  std::vector<Rational> events(const Pixel& pixel) const;

  /// What is seen along the pixel's centre by a camera at t.
  Look look(const Pixel& pixel, const Rational& t) const;

  /// Whether the camera lies on an occluder at t.
  bool on_occluder(const Rational& t) const;

  /// The parts of [0, 1] between events, joined where neighbours show one set. What is in R10° on one of them
  /// is added to `proper` where that is given. R10° is to be contained in R9 and to have witnesses (R11):
  /// both know no camera that lies on an occluder, though R6 lets it see; so on a segment of positive length
  /// such times do not count for R10°. Without length R9 is R7, which answers there too.
  ExactSights sights(const Pixel& pixel, std::set<PrimitiveId>* proper = nullptr) const;

  /// Every pixel of every frame.
  SegmentAnswer answer() const;

 private:
  using Surfaces = std::vector<const Surface*>;

  /// The rays along one pixel's centre.
  struct Path {
    Integer3 from, to, direction;

    ExactRay ray(const Rational& t) const;
  };

  /// Where the camera enters or leaves a triangle in whose plane it moves.
  std::vector<Rational> borders_of(const Surface& floor) const;

  Path path(const Pixel& pixel) const;
  bool is_missed(const Surface& surface, const Path& path) const;
  Surfaces met(const Path& path) const;
  std::vector<Rational> own_events(const Surface& surface, const Path& path) const;
  std::vector<Rational> events(const Surfaces& met, const Path& path) const;
  std::vector<Rational> in_order(std::vector<Rational> events) const;
  Look look(const Surfaces& met, const ExactRay& ray) const;

  SegmentView view_;
  SegmentPlant plant_;
  CommonScale scale_;
  Integer3 from_, to_;
  std::vector<Surface> surfaces_;
  std::vector<Surface> floors_;  ///< occluders in whose plane the camera moves, if it moves
};

inline SegmentAnswer oracle_along(const SceneArrays& scene, const SegmentView& view,
                                  SegmentPlant plant = SegmentPlant::none) {
  return SegmentOracle(scene, view, plant).answer();
}

}  // namespace provis::test
