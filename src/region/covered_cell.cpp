#include "src/region/covered_cell.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"
#include "predicates/plane_side.hpp"
#include "predicates/zero_area.hpp"
#include "src/lod/plane_cells.hpp"

namespace provis {
namespace {

using Corners = std::array<Vec3d, 3>;

/// The opaque triangles of some area that lie in a plane or around a line with all of the cell.
std::vector<Corners> occluders_in_line(const Scene& scene, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  std::vector<Corners> found;
  for (PrimitiveId t = 0; t < scene.triangles().size(); ++t) {
    const Corners at{scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2)};
    const auto on = [&](const Vec3d& p) { return plane_side(at[0], at[1], at[2], p) == Sign::zero; };
    if (!(scene.triangle_flags()[t] & see_through) && on(a) && on(b) && on(c) &&
        !zero_area(at[0], at[1], at[2]))
      found.push_back(at);
  }
  return found;
}

bool covers(const std::vector<Corners>& occluders, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  lod::PlaneCells cells(a, b, c);
  for (const Corners& t : occluders)
    cells.add_cover({{numbers<Rational>(t[0]), numbers<Rational>(t[1]), numbers<Rational>(t[2])}});
  return !cells.any(
      [](const lod::Point&, const std::vector<const lod::Cover*>& over) { return over.empty(); });
}

/// From where to where a triangle around the line of a segment covers it, in shares of the segment.
std::optional<std::pair<Rational, Rational>> stretch(const Corners& t, const Vec3d& from, const Vec3d& to) {
  const auto corner = [&](int k) { return numbers<Rational>(t[static_cast<std::size_t>(k % 3)]); };
  const Vec3<Rational> normal = cross(corner(1) - corner(0), corner(2) - corner(0));
  Rational begin = 0, end = 1;
  for (int k = 0; k < 3; ++k) {
    const Vec3<Rational> inwards = cross(normal, corner(k + 1) - corner(k));
    const Rational first = dot(inwards, numbers<Rational>(from) - corner(k)),
                   last = dot(inwards, numbers<Rational>(to) - corner(k));
    if (first < 0 && last < 0) return std::nullopt;
    if (first == last) continue;
    const Rational crossing = first / (first - last);
    if (first < 0) begin = std::max(begin, crossing);
    if (last < 0) end = std::min(end, crossing);
  }
  if (begin > end) return std::nullopt;
  return std::pair(begin, end);
}

bool covers(const std::vector<Corners>& occluders, const Vec3d& from, const Vec3d& to) {
  std::vector<std::pair<Rational, Rational>> stretches;
  for (const Corners& t : occluders)
    if (const auto s = stretch(t, from, to)) stretches.push_back(*s);
  std::sort(stretches.begin(), stretches.end());
  // What is not covered is open: a gap has a length, or is an end.
  Rational reached = 0;
  if (stretches.empty() || stretches.front().first > 0) return false;
  for (const auto& [begin, end] : stretches) {
    if (begin > reached) return false;
    reached = std::max(reached, end);
  }
  return reached >= 1;
}

}  // namespace

bool lies_on_occluders(const Scene& scene, const ViewCell& cell) {
  const Vec3d &lo = cell.lower, &hi = cell.upper;
  const RoundUp guard;
  std::vector<int> long_axes;
  for (int axis = 0; axis < 3; ++axis)
    if (component(lo, axis) < component(hi, axis)) long_axes.push_back(axis);
  if (long_axes.size() == 3) return false;
  if (long_axes.size() < 2) return covers(occluders_in_line(scene, lo, hi, hi), lo, hi);
  Vec3d along = lo, aside = lo;
  component(along, long_axes[0]) = component(hi, long_axes[0]);
  component(aside, long_axes[1]) = component(hi, long_axes[1]);
  const std::vector<Corners> occluders = occluders_in_line(scene, lo, along, aside);
  return covers(occluders, lo, along, hi) && covers(occluders, lo, hi, aside);
}

}  // namespace provis
