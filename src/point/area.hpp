#pragma once
// Exact window coordinates and areas of cells.

#include <cstdint>
#include <vector>

#include "predicates/exact_number.hpp"
#include "predicates/rational.hpp"
#include "src/point/cell.hpp"

namespace provis {

/// The window coordinates (x/w, y/w) of a ray, not divided yet: every division costs a greatest common
/// divisor of long numbers.
struct WindowPoint {
  ExactNumber x, y, w;
};

/// Where the ray meets the window. Requires: the ray lies in the image.
WindowPoint window_point(const ViewGeometry& g, const Direction& ray);

/// The divided coordinates, rounded for display.
Vec3d rounded(const WindowPoint& p);

std::vector<WindowPoint> window_polygon(const ViewGeometry& g, const Cell& cell);

/// Positive area of a convex polygon, whichever way round it is listed.
Rational area(const std::vector<WindowPoint>& polygon);

/// Sums of exact areas modulo the prime 2^61 - 1: enough to notice any lost or doubled area, without the
/// common denominators that make a sum of a thousand rationals slow.
class AreaBalance {
 public:
  void add(const Rational& area) { sum_ = (sum_ + residue(area)) % prime; }
  bool equals(const Rational& total) const { return sum_ == residue(total); }

 private:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;
  static std::uint64_t residue(const Rational& q);

  std::uint64_t sum_ = 0;
};

}  // namespace provis
