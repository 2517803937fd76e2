#include "src/offset/target.hpp"

#include <algorithm>
#include <cmath>

namespace provis::offset {
namespace {

/// The extent of a polygon along an axis.
Interval extent(const Polygon& p, int axis) {
  double lo = HUGE_VAL, hi = -HUGE_VAL;
  for (std::size_t k = 0; k < p.size; ++k) {
    const Interval& x = component(p.corners[k].at, axis);
    lo = std::min(lo, x.inf());
    hi = std::max(hi, x.sup());
  }
  return {lo, hi};
}

bool certainly(const std::optional<Sign>& s, Sign wanted) { return s && *s == wanted; }

std::optional<Sign> turn_of(const Mesh::Edge& edge, const Facet& f, const Corner& corner,
                            const Vec3d& viewpoint) {
  if (corner.input < 0)
    return sign_of(turn(*edge.ends[0], *edge.ends[1], corner.at, numbers<Interval>(viewpoint)));
  const auto i = static_cast<std::size_t>(corner.input);
  if (f.v[i] == edge.v[0] || f.v[i] == edge.v[1]) return Sign::zero;
  return turn(*edge.ends[0], *edge.ends[1], *f.p[i], viewpoint);
}

}  // namespace

/// A mean of the corners.
Point inner_point(const Polygon& p) {
  Point sum = p.corners[0].at;
  for (std::size_t k = 1; k < p.size; ++k) sum = sum + p.corners[k].at;
  return Interval(1) / Interval(p.size) * sum;
}

bool lies_beyond(const Facet& occluder, const Target& target) {
  const Facet& f = target.facet;
  bool strictly = false;
  for (std::size_t k = 0; k < target.polygon.size; ++k) {
    const Corner& c = target.polygon.corners[k];
    std::optional<Sign> s;
    if (c.input >= 0) {
      const auto i = static_cast<std::size_t>(c.input);
      if (std::find(occluder.v.begin(), occluder.v.end(), f.v[i]) != occluder.v.end()) continue;
      s = beyond(occluder, *f.p[i]);
    } else {
      s = beyond(occluder, c.at);
    }
    if (!s) return lies_beyond(occluder, f);
    if (*s == Sign::negative) return false;
    strictly = strictly || *s == Sign::positive;
  }
  return strictly;
}

bool lies_beyond(const Facet& occluder, const Facet& f) {
  bool strictly = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::find(occluder.v.begin(), occluder.v.end(), f.v[k]) != occluder.v.end()) continue;
    const Sign s = beyond(occluder, *f.p[k]);
    if (s == Sign::negative) return false;
    strictly = strictly || s == Sign::positive;
  }
  return strictly;
}

bool boxes_apart(const Facet& occluder, const Target& target) {
  for (int axis = 0; axis < 3; ++axis) {
    const Interval of_target = extent(target.polygon, axis);
    const double a = component(*occluder.p[0], axis), b = component(*occluder.p[1], axis),
                 c = component(*occluder.p[2], axis);
    if (std::max({a, b, c}) < of_target.inf() || std::min({a, b, c}) > of_target.sup()) return true;
  }
  return false;
}

bool may_be_crossed(const Mesh::Edge& edge, const Face& face, const Target& target) {
  const Facet& f = target.facet;
  for (int axis = 0; axis < 3; ++axis) {
    const Interval of_target = extent(target.polygon, axis);
    const double lo = std::min(component(face.corners[0], axis), of_target.inf()),
                 hi = std::max(component(face.corners[2], axis), of_target.sup());
    const double a = component(*edge.ends[0], axis), b = component(*edge.ends[1], axis);
    if ((a < lo && b < lo) || (a > hi && b > hi)) return false;
  }
  // The product is linear in the viewpoint and in the point of the polygon, so its signs at corners are those
  // inside; where it has one sign the line through the edge is passed on one side.
  bool left = false, right = false, known = true;
  for (std::size_t k = 0; k < target.polygon.size && known && !(left && right); ++k)
    for (const Vec3d& o : face.corners) {
      const auto s = turn_of(edge, f, target.polygon.corners[k], o);
      known = known && s.has_value();
      left = left || certainly(s, Sign::positive);
      right = right || certainly(s, Sign::negative);
    }
  if (known && left != right) return false;
  const auto not_before = [&](std::size_t end) {
    return std::find(f.v.begin(), f.v.end(), edge.v[end]) != f.v.end() ||
           beyond(f, *edge.ends[end]) != Sign::negative;
  };
  return !(f.faced && not_before(0) && not_before(1));
}

}  // namespace provis::offset
