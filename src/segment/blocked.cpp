#include "src/segment/blocked.hpp"

#include <algorithm>

#include "predicates/environment.hpp"
#include "predicates/exact_number.hpp"
#include "predicates/plane_side.hpp"
#include "predicates/zero_area.hpp"

namespace provis {
namespace {

using N = ExactNumber;

struct Extent {
  double low, high;
};

bool apart(const Extent& path, double a, double b, double c) {
  return std::max({a, b, c}) < path.low || std::min({a, b, c}) > path.high;
}

ExactTime root(const Linear<N>& f) {
  return static_cast<ExactTime>(f.at_zero) / static_cast<ExactTime>(f.slope);
}

/// The normal's product with (b - a) x (v(t) - a): not negative where v(t) is on the inner side of the edge.
Linear<N> inside(const Vec3<N>& n, const Vec3<N>& a, const Vec3<N>& b, const Vec3<N>& from,
                 const Vec3<N>& step) {
  return {dot(n, cross(b - a, from - a)), -dot(n, cross(b - a, step))};
}

}  // namespace

BlockedTimes::BlockedTimes(const Scene& scene, const Vec3d& from, const Vec3d& to)
    : scene_(scene), from_(from), to_(to) {
  if (from == to) return;
  const Extent x{std::min(from.x, to.x), std::max(from.x, to.x)},
      y{std::min(from.y, to.y), std::max(from.y, to.y)}, z{std::min(from.z, to.z), std::max(from.z, to.z)};
  for (std::size_t t = 0; t < scene.triangles().size(); ++t) {
    if (scene.triangle_flags()[t] & see_through) continue;
    const Vec3d &a = scene.corner(t, 0), &b = scene.corner(t, 1), &c = scene.corner(t, 2);
    if (apart(x, a.x, b.x, c.x) || apart(y, a.y, b.y, c.y) || apart(z, a.z, b.z, c.z) || zero_area(a, b, c))
      continue;
    near_.push_back(static_cast<PrimitiveId>(t));
  }
  const Vec3<N> o = numbers<N>(from), step = numbers<N>(to) - o;
  for (const PrimitiveId t : near_) {
    const Vec3<N> p[3] = {numbers<N>(scene.corner(t, 0)), numbers<N>(scene.corner(t, 1)),
                          numbers<N>(scene.corner(t, 2))};
    const Vec3<N> n = cross(p[1] - p[0], p[2] - p[0]);
    if (sign_of(dot(n, p[0] - o)) != Sign::zero || sign_of(dot(n, step)) != Sign::zero) continue;
    ExactTime begin = 0, end = 1;
    bool empty = false;
    for (int k = 0; k < 3; ++k) {
      const Linear<N> f = inside(n, p[k], p[(k + 1) % 3], o, step);
      const Sign slope = sign_of(f.slope);
      if (slope == Sign::zero) {
        empty = empty || sign_of(f.at_zero) == Sign::negative;
      } else if (slope == Sign::positive) {
        end = std::min(end, root(f));
      } else {
        begin = std::max(begin, root(f));
      }
    }
    if (!empty && begin < end) parts_.emplace_back(begin, end);
  }
  std::sort(parts_.begin(), parts_.end());
}

std::optional<std::pair<ExactTime, ExactTime>> BlockedTimes::first_gap(const ExactTime& begin,
                                                                       const ExactTime& end) const {
  ExactTime free = begin;
  for (const auto& [from, to] : parts_) {
    if (from > free) return std::pair(free, std::min(from, end));
    free = std::max(free, to);
    if (free >= end) return std::nullopt;
  }
  return std::pair(free, end);
}

bool BlockedTimes::at(const ExactTime& t) const {
  if (near_.empty()) return false;
  const RoundUp guard;
  const auto viewpoint = [&]<class Number>(const Number& when) {
    const Vec3<Number> o = numbers<Number>(from_);
    return o + when * (numbers<Number>(to_) - o);
  };
  const Vec3<Interval> bounds = viewpoint(Interval(CGAL::to_interval(t)));
  const auto extent = [&](int axis) {
    return Extent{component(bounds, axis).inf(), component(bounds, axis).sup()};
  };
  const Extent x = extent(0), y = extent(1), z = extent(2);
  const Vec3<ExactTime> v = viewpoint(t);
  return std::any_of(near_.begin(), near_.end(), [&](PrimitiveId id) {
    const Vec3d &a = scene_.corner(id, 0), &b = scene_.corner(id, 1), &c = scene_.corner(id, 2);
    if (apart(x, a.x, b.x, c.x) || apart(y, a.y, b.y, c.y) || apart(z, a.z, b.z, c.z)) return false;
    if (const auto s = sign_of(plane_height(a, b, c, bounds)); s && *s != Sign::zero) return false;
    if (plane_height(a, b, c, v) != 0) return false;
    const Vec3<ExactTime> p = numbers<ExactTime>(a), q = numbers<ExactTime>(b), r = numbers<ExactTime>(c),
                          n = cross(q - p, r - p);
    return dot(n, cross(q - p, v - p)) >= 0 && dot(n, cross(r - q, v - q)) >= 0 &&
           dot(n, cross(p - r, v - r)) >= 0;
  });
}

}  // namespace provis
