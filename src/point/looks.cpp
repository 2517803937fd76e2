#include "src/point/looks.hpp"

#include <cmath>
#include <limits>
#include <numeric>

namespace provis {

std::vector<std::uint32_t> overlapping(const Facets& facets, std::span<const std::uint32_t> list,
                                       const Window& rectangle) {
  std::vector<std::uint32_t> out;
  double covered = -HUGE_VAL;
  for (const std::uint32_t k : list) {
    const Facet& f = facets.facets[k];
    if (!overlap(f.box, rectangle) || separated(f, rectangle)) continue;
    out.push_back(k);
    if (f.occludes && covers(f, rectangle)) covered = std::fmax(covered, f.depth.lowest(rectangle));
  }
  std::erase_if(out, [&](std::uint32_t k) { return facets.facets[k].depth.highest(rectangle) < covered; });
  return out;
}

std::vector<std::uint32_t> overlapping(const Facets& facets, const Window& rectangle) {
  std::vector<std::uint32_t> all(facets.facets.size());
  std::iota(all.begin(), all.end(), 0u);
  return overlapping(facets, all, rectangle);
}

WindowMap::WindowMap(const ViewGeometry& g) {
  const Vec3<Ball> center = frame_center<Ball>(g), right = project_vector<Ball>(g, g.right),
                   up = project_vector<Ball>(g, g.up);
  x_ = approximate(cross(up, center));
  y_ = approximate(cross(center, right));
  w_ = approximate(cross(right, up));
  if (g.handedness == Sign::negative)
    for (Approx* functional : {&x_, &y_, &w_}) functional->v = -functional->v;
}

WindowPlace WindowMap::place(const ApproxDirection& ray) const {
  const FilteredValue x = evaluate(x_, ray), y = evaluate(y_, ray), w = evaluate(w_, ray);
  return window_place({approximate({x.value, y.value, w.value}, std::max({x.bound, y.bound, w.bound}))});
}

Window box_of(std::span<const WindowPlace> places) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Window box{infinity, -infinity, infinity, -infinity};
  for (const WindowPlace& p : places) {
    if (!(p.error < infinity)) return {-infinity, infinity, -infinity, infinity};
    // The sums are rounded, by less than this.
    const double r = (p.error + 4 * unit_roundoff * (std::fabs(p.x) + std::fabs(p.y))) * (1 + 0x1p-20);
    box = {std::fmin(box.x0, p.x - r), std::fmax(box.x1, p.x + r), std::fmin(box.y0, p.y - r),
           std::fmax(box.y1, p.y + r)};
  }
  return box;
}

}  // namespace provis
