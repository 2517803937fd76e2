#pragma once
// View cells beside, around and inside of generated scenes, and an independent look at what is seen from
// them.

#include <gmpxx.h>

#include <set>
#include <string>
#include <vector>

#include "provis/cell.hpp"
#include "tests/support/case.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

/// A cell for the scene of a case: on the grid of its coordinates more often than not, so that faces of the
/// box lie in planes of the scene, corners on its vertices, and triangles in the box; sometimes flat, thin or
/// tiny; in one case of ten with a window.
ViewCell any_cell(const Case& c, Random& random);

/// Queries of small scenes are over before a second thread wakes.
inline Context one_thread() {
  Context context;
  context.threads = 1;
  return context;
}

/// Little of everything.
inline CellOptions small_options(CellMethod method, int viewpoints, int rays) {
  CellOptions o;
  o.method = method;
  o.pixels = {4, 4};
  o.viewpoints = viewpoints;
  o.directions = 1;
  o.path_pixels = 2;
  o.rays = rays;
  return o;
}

/// Of what was seen, what is called hidden: empty, or there is a mistake.
std::vector<PrimitiveId> hidden_among(const CellSet& upper, const std::vector<PrimitiveId>& seen);

/// The text form of a case with its cell.
std::string describe(const Case& c, const ViewCell& cell);

/// Exact rays out of a cell, held against every triangle over rational numbers. Shares no code with the
/// engine.
class CellRays {
 public:
  CellRays(const SceneArrays& scene, const ViewCell& cell) : scene_(scene), cell_(cell) {}

  /// Draws a viewpoint of the closed cell and a direction of its window, mostly towards some triangle.
  /// Returns the triangles that the ray proves visible (R11); none if the viewpoint lies on an occluder.
  std::vector<PrimitiveId> seen(Random& random) const;

 private:
  using Rational = mpq_class;
  using Rational3 = Vec3<mpq_class>;
  struct Hit;

  Rational3 any_viewpoint(Random& random) const;
  Rational3 any_direction(const Rational3& viewpoint, Random& random) const;
  bool in_window(const Rational3& direction) const;
  std::vector<Hit> hits(const Rational3& viewpoint, const Rational3& direction) const;
  bool on_occluder(const Rational3& viewpoint) const;

  const SceneArrays& scene_;
  const ViewCell& cell_;
};

}  // namespace provis::test
