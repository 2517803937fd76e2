#pragma once
// Exact window coordinates and areas of cells.

#include <CGAL/Gmpq.h>

#include <vector>

#include "src/point/cell.hpp"

namespace provis {

using Rational = CGAL::Gmpq;

struct WindowPoint {
  Rational x, y;
};

/// Where the ray meets the window. Requires: the ray lies in the image.
WindowPoint window_point(const ViewGeometry& g, const Direction& ray);

std::vector<WindowPoint> window_polygon(const ViewGeometry& g, const Cell& cell);

/// Positive area of a convex polygon, whichever way round it is listed.
Rational area(const std::vector<WindowPoint>& polygon);

}  // namespace provis
