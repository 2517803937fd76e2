#pragma once
// The oracle for a segment: visibility at pixel centres (R10) by listing every event, as plain as it can be.
// It shares no code with the engine. Triangles only: a scene with spheres is refused (std::logic_error).

#include <set>
#include <vector>

#include "provis/scene.hpp"
#include "provis/segment.hpp"
#include "tests/support/exact_hit.hpp"

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
  std::uint64_t pixels = 0;
  Rational length;
};

struct SegmentAnswer {
  std::vector<PrimitiveId> visible;   ///< R10, ascending
  std::vector<PrimitiveId> boundary;  ///< of these, the ones that are not in R10°; ascending
  std::vector<ExactSights> pixels;    ///< in order of frame, row and column
  std::vector<ExactSeen> seen;        ///< one per visible triangle, ascending
};

/// One centre to look along.
struct Pixel {
  int frame = 0, column = 0, row = 0;
};

/// What one ray sees.
struct Look {
  std::vector<PrimitiveId> visible;  ///< closed hits that no occluder hides, ascending
  std::vector<PrimitiveId> proper;   ///< of these: hit inside, and each occluder as near lies in their plane
  Rational nearest;  ///< distance of the nearest occluder, in units of the direction; 0 where there is none
};

/// One scene and one segment, to be asked pixel by pixel.
class SegmentOracle {
 public:
  SegmentOracle(const SceneArrays& scene, const SegmentView& view, SegmentPlant plant = SegmentPlant::none);

  /// 0, 1, and every t between them at which anything may change along the pixel's centre; ascending.
  std::vector<Rational> events(const Pixel& pixel) const;

  /// What is seen along the pixel's centre by a camera at t.
  Look look(const Pixel& pixel, const Rational& t) const;

  /// The parts of [0, 1] between events, joined where neighbours show one set. What is in R10° on one of them
  /// is added to `proper` where that is given.
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

  Path path(const Pixel& pixel) const;
  Surfaces met(const Path& path) const;
  std::vector<Rational> own_events(const Surface& surface, const Path& path) const;
  std::vector<Rational> events(const Surfaces& met, const Path& path) const;
  std::vector<Rational> in_order(std::vector<Rational> events) const;
  Look look(const Surfaces& met, const ExactRay& ray) const;

  SegmentView view_;
  SegmentPlant plant_;
  Integer3 from_, to_;
  std::vector<Surface> surfaces_;
};

inline SegmentAnswer oracle_along(const SceneArrays& scene, const SegmentView& view,
                                  SegmentPlant plant = SegmentPlant::none) {
  return SegmentOracle(scene, view, plant).answer();
}

}  // namespace provis::test
