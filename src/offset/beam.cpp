#include "src/offset/beam.hpp"

#include <algorithm>
#include <cmath>

namespace provis::offset {
namespace {

/// A mean of the corners: a point of the polygon's relative interior.
Point inner_point(const Polygon& p) {
  Point sum = p.corners[0].at;
  for (std::size_t k = 1; k < p.size; ++k) sum = sum + p.corners[k].at;
  return Interval(1) / Interval(p.size) * sum;
}

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

}  // namespace

Polygon polygon_of(const Entry& entry, const Facet& facet) {
  if (entry.cut) return *entry.cut;
  return whole(*facet.p[0], *facet.p[1], *facet.p[2]);
}

std::optional<bool> Resolver::aims_at(const Facet& f, const Point& from, const Point& to) const {
  bool left = false, right = false, all_left = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const Interval t = turn(*f.p[k], *f.p[(k + 1) % 3], to, from);
    left = left || t.inf() > 0;
    right = right || t.sup() < 0;
    all_left = all_left && t.inf() > 0;
  }
  // A faced triangle is hit only where all three are positive.
  if (f.faced ? right : left && right) return false;
  return f.faced && all_left ? std::optional(true) : std::nullopt;
}

std::optional<bool> Resolver::crosses(const Facet& f, const Point& from, const Point& to) const {
  const std::optional<bool> aimed = aims_at(f, from, to);
  if (aimed == false || !f.faced) return aimed;
  const std::optional<Sign> side = beyond(f, to);
  if (certainly(side, Sign::negative)) return false;
  return certainly(side, Sign::positive) ? aimed : std::nullopt;
}

Beam::Beam(const Face& viewpoints, const Raster& raster, const Shafts& shafts, const Window& window)
    : face(viewpoints), directions(window), spaces(shafts.around(viewpoints, window)) {
  const auto mean = [](const Point& a, const Point& b) { return Interval(0.5) * (a + b); };
  viewpoint = mean(numbers<Interval>(face.corners[0]), numbers<Interval>(face.corners[2]));
  const Frame& f = raster.frame;
  const Interval x = Interval(0.5) * (Interval(window.x0) + Interval(window.x1)),
                 y = Interval(0.5) * (Interval(window.y0) + Interval(window.y1));
  ray = numbers<Interval>(f.forward) + x * numbers<Interval>(f.right) + y * numbers<Interval>(f.up);
}

std::optional<Cover> Resolver::cover(const Beam& beam, const std::vector<Entry>& list) {
  // Where a window leads back into the cell too, only the rays that leave it count.
  const Interval& out = component(beam.ray, beam.face.axis);
  if (!(beam.face.upper ? out.inf() > 0 : out.sup() < 0)) return std::nullopt;
  const Point ahead = beam.viewpoint + beam.ray;
  const auto any = [](std::uint32_t) { return true; };
  const auto reaches = [&](const Mesh::Edge& e) { return !misses(*e.ends[0], *e.ends[1], beam.spaces); };
  std::size_t seeds = 0;
  for (const Entry& entry : list) {
    const Facet& f = facets_[entry.facet];
    if (!f.occludes || aims_at(f, beam.viewpoint, ahead) != true) continue;
    if (++seeds > most_seeds) break;
    const auto members = fusion_.grow(entry.facet, most_members, any, reaches);
    if (!members) continue;
    return Cover{farthest(*members, list), *members};
  }
  return std::nullopt;
}

/// Of what the members have in the beam; of all of a member that is not in the list.
double Resolver::farthest(const std::vector<std::uint32_t>& members, const std::vector<Entry>& list) {
  for (std::uint32_t k = 0; k < list.size(); ++k) place_[list[k].facet] = k;
  double far = -HUGE_VAL;
  for (const std::uint32_t m : members) {
    if (place_[m] < list.size() && list[place_[m]].facet == m) {
      far = std::max(far, list[place_[m]].far);
      continue;
    }
    for (const Vec3d* p : facets_[m].p) far = std::max(far, shafts_.depth(numbers<Interval>(*p)).sup());
  }
  return far;
}

bool Resolver::behind(const Cover& cover, const Entry& entry) const {
  if (entry.near > cover.far) return true;
  constexpr std::size_t few = 16;
  const Facet& facet = facets_[entry.facet];
  return cover.members.size() <= few &&
         std::all_of(cover.members.begin(), cover.members.end(), [&](std::uint32_t m) {
           if (m == entry.facet) return false;
           return entry.cut ? lies_beyond(facets_[m], Target{facet, *entry.cut})
                            : lies_beyond(facets_[m], facet);
         });
}

/// All of the polygon lies on the far side of the occluder's plane or in it, and not all of it in it.
bool Resolver::lies_beyond(const Facet& occluder, const Target& target) {
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

bool Resolver::lies_beyond(const Facet& occluder, const Facet& f) {
  bool strictly = false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (std::find(occluder.v.begin(), occluder.v.end(), f.v[k]) != occluder.v.end()) continue;
    const Sign s = beyond(occluder, *f.p[k]);
    if (s == Sign::negative) return false;
    strictly = strictly || s == Sign::positive;
  }
  return strictly;
}

bool Resolver::boxes_apart(const Facet& occluder, const Target& target) {
  for (int axis = 0; axis < 3; ++axis) {
    const Interval of_target = extent(target.polygon, axis);
    const double a = component(*occluder.p[0], axis), b = component(*occluder.p[1], axis),
                 c = component(*occluder.p[2], axis);
    if (std::max({a, b, c}) < of_target.inf() || std::min({a, b, c}) > of_target.sup()) return true;
  }
  return false;
}

std::optional<Sign> Resolver::turn_of(const Mesh::Edge& edge, const Facet& f, const Corner& corner,
                                      const Vec3d& viewpoint) {
  if (corner.input < 0)
    return sign_of(turn(*edge.ends[0], *edge.ends[1], corner.at, numbers<Interval>(viewpoint)));
  const auto i = static_cast<std::size_t>(corner.input);
  if (f.v[i] == edge.v[0] || f.v[i] == edge.v[1]) return Sign::zero;
  return turn(*edge.ends[0], *edge.ends[1], *f.p[i], viewpoint);
}

/// False only if no segment from inside the face to the inside of the polygon meets the edge on its way.
bool Resolver::may_be_crossed(const Mesh::Edge& edge, const Face& face, const Target& target) {
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

/// A point of the face from which the beam's middle direction, or one near it, leads to the point.
Point Resolver::viewpoint_towards(const Beam& beam, const Point& to) const {
  const Face& face = beam.face;
  const auto middle = [](const Interval& x) { return 0.5 * x.inf() + 0.5 * x.sup(); };
  const double way =
      (middle(component(to, face.axis)) - face.height) / middle(component(beam.ray, face.axis));
  Point from = numbers<Interval>(face.corners[0]);
  for (const int axis : {(face.axis + 1) % 3, (face.axis + 2) % 3}) {
    const double at = middle(component(to, axis)) - way * middle(component(beam.ray, axis)),
                 lo = component(face.corners[0], axis), hi = component(face.corners[2], axis);
    // No number if the beam runs along the face.
    component(from, axis) = Interval(at >= lo ? std::min(at, hi) : lo);
  }
  return from;
}

Failure Resolver::hide(const Beam& beam, const std::vector<Entry>& list, const Entry& entry) {
  const Polygon polygon = polygon_of(entry, facets_[entry.facet]);
  const Target target{facets_[entry.facet], polygon};
  const Point to = inner_point(polygon), from = viewpoint_towards(beam, to);
  const auto usable = [&](std::uint32_t m) {
    const Facet& f = facets_[m];
    return m != entry.facet && (lies_beyond(f, target) || boxes_apart(f, target));
  };
  const auto may_cross = [&](const Mesh::Edge& e) { return may_be_crossed(e, beam.face, target); };
  std::size_t seeds = 0;
  Failure first = Failure::nothing_between;
  bool clear = facets_[entry.facet].faced && shafts_.holds(beam.directions, to - from);
  for (const Entry& occluder : list) {
    if (occluder.near > entry.far) break;  // the list is in order of least depth
    const Facet& f = facets_[occluder.facet];
    if (!f.opaque || occluder.facet == entry.facet || (!f.occludes && !clear)) continue;
    const std::optional<bool> crossed = crosses(f, from, to);
    clear = clear && crossed == false;
    if (!f.occludes || crossed != true) continue;
    if (++seeds > most_seeds) break;
    if (fusion_.grow(occluder.facet, most_members, usable, may_cross)) return Failure::none;
    if (seeds == 1) first = fusion_.failure();
  }
  return clear ? Failure::seen : first;
}

}  // namespace provis::offset
