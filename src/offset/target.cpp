#include "src/offset/target.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/certain_sign.hpp"

namespace provis::offset {

/// A mean of the corners.
Point inner_point(const Polygon& p) {
  Point sum = p.corners[0].at;
  for (std::size_t k = 1; k < p.size; ++k) sum = sum + p.corners[k].at;
  return Interval(1) / Interval(p.size) * sum;
}

bool lies_beyond(const Facet& occluder, const Facet& f, const Polygon& polygon) {
  bool strictly = false;
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const Corner& c = polygon.corners[k];
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

Target::Target(const Facet& facet, const Polygon& polygon, const Face& face)
    : facet_(facet), polygon_(polygon), face_(face) {
  box_ = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
  for (std::size_t k = 0; k < polygon.size; ++k) {
    const Point& p = polygon.corners[k].at;
    for (int axis = 0; axis < 3; ++axis) {
      double &lo = component(box_.lower, axis), &hi = component(box_.upper, axis);
      lo = std::min(lo, component(p, axis).inf());
      hi = std::max(hi, component(p, axis).sup());
    }
    for (std::size_t r = 0; r < face.corners.size(); ++r)
      segments_[r][k] = p - numbers<Interval>(face.corners[r]);
  }
}

bool Target::box_apart_from(const Facet& occluder) const {
  return !meet(box_, box_around(*occluder.p[0], *occluder.p[1], *occluder.p[2]));
}

/// The determinant of `turn` is linear in the viewpoint and in the point of the polygon, so its signs at
/// corners are those inside; where it has one sign the line through the edge is passed on one side.
bool Target::passed_on_one_side(const Mesh::Edge& edge) const {
  const Vec3d &a = *edge.ends[0], &b = *edge.ends[1];
  bool left = false, right = false;
  for (std::size_t r = 0; r < face_.corners.size(); ++r) {
    const Vec3d& o = face_.corners[r];
    const Point eye = numbers<Interval>(o),
                normal = cross(numbers<Interval>(a) - eye, numbers<Interval>(b) - eye);
    for (std::size_t k = 0; k < polygon_.size; ++k) {
      const int input = polygon_.corners[k].input;
      const auto i = static_cast<std::size_t>(input);
      if (input >= 0 && (facet_.v[i] == edge.v[0] || facet_.v[i] == edge.v[1])) continue;  // zero
      std::optional<Sign> s = sign_of(dot(normal, segments_[r][k]));
      if (input >= 0) {
        if (s)
          ++certain_signs.interval;
        else
          s = turn(a, b, *facet_.p[i], o);
      }
      if (!s) return false;
      left = left || *s == Sign::positive;
      right = right || *s == Sign::negative;
      if (left && right) return false;
    }
  }
  return left != right;
}

bool Target::may_meet(const Mesh::Edge& edge) const {
  for (int axis = 0; axis < 3; ++axis) {
    const double lo = std::min(component(face_.corners[0], axis), component(box_.lower, axis)),
                 hi = std::max(component(face_.corners[2], axis), component(box_.upper, axis));
    const double a = component(*edge.ends[0], axis), b = component(*edge.ends[1], axis);
    if ((a < lo && b < lo) || (a > hi && b > hi)) return false;
  }
  if (passed_on_one_side(edge)) return false;
  const auto not_before = [&](std::size_t end) {
    return std::find(facet_.v.begin(), facet_.v.end(), edge.v[end]) != facet_.v.end() ||
           beyond(facet_, *edge.ends[end]) != Sign::negative;
  };
  return !(facet_.faced && not_before(0) && not_before(1));
}

}  // namespace provis::offset
