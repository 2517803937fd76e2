#pragma once
// Facets as rays and rectangles of the window see them, by float64 with a bound. What these numbers cannot
// tell is asked of Signs.

#include <algorithm>
#include <span>
#include <vector>

#include "src/point/facets.hpp"

namespace provis {

enum class Hit : std::uint8_t {
  none,    ///< certainly not hit
  unsure,  ///< the signs have to be asked
  inside,  ///< certainly hit in the relative interior
};

inline Hit hit(const Facet& f, double x, double y) {
  bool inside = true;
  const auto out = [&](double value, double error) {
    inside &= value > error;
    return value < -error;
  };
  for (const WindowFunction& e : f.inside)
    if (out(e.at(x, y), e.error)) return Hit::none;
  if (f.cut && out(-f.depth.at(x, y), f.depth.error)) return Hit::none;
  return inside ? Hit::inside : Hit::unsure;
}

/// Whether one of its own lines certainly separates the facet from the rectangle.
inline bool separated(const Facet& f, const Window& w) {
  return std::any_of(std::begin(f.inside), std::end(f.inside),
                     [&](const WindowFunction& e) { return e.highest(w) < 0; }) ||
         (f.cut && f.depth.lowest(w) > 0);
}

/// Whether every ray of the closed rectangle certainly hits the facet inside.
inline bool covers(const Facet& f, const Window& w) {
  return std::all_of(std::begin(f.inside), std::end(f.inside),
                     [&](const WindowFunction& e) { return e.lowest(w) > 0; }) &&
         (!f.cut || f.depth.highest(w) < 0);
}

/// Those of the list that may have a hit in the closed rectangle and do not certainly lie behind an occluder
/// that certainly covers all of it.
std::vector<std::uint32_t> overlapping(const Facets& facets, std::span<const std::uint32_t> list,
                                       const Window& rectangle);
/// The same of all facets.
std::vector<std::uint32_t> overlapping(const Facets& facets, const Window& rectangle);

/// Projects rays of one frame to the window.
class WindowMap {
 public:
  explicit WindowMap(const ViewGeometry& geometry);

  /// The error is infinite where the ray is not certainly in front.
  WindowPlace place(const ApproxDirection& ray) const;

 private:
  Approx x_, y_, w_;  ///< window coordinates are quotients of these functionals, the last positive in front
};

/// Holds the convex hull of the places; everything where one is not known.
Window box_of(std::span<const WindowPlace> places);

}  // namespace provis
