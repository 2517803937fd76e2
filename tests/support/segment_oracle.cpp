#include "tests/support/segment_oracle.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

namespace provis::test {

namespace {

CommonScale scale_of(const SceneArrays& scene, const SegmentView& view) {
  CommonScale scale;
  scale.include(view.from);
  scale.include(view.to);
  for (const Triangle& t : scene.triangles) {
    for (const std::uint32_t v : t) scale.include(scene.vertices[v]);
  }
  return scale;
}

/// Where an affine function of t with these values at 0 and 1 vanishes, if once and strictly between them.
std::optional<Rational> root(const Integer& at_0, const Integer& at_1) {
  if (sgn(at_0) * sgn(at_1) >= 0) return {};
  Rational t(at_0, at_0 - at_1);
  t.canonicalize();
  return t;
}

/// R8, times a positive integer.
Integer3 centre(const Frame& frame, const PixelGrid& grid, const Pixel& pixel) {
  const Window& w = frame.window;
  const Rational x0 = w.x0, x1 = w.x1, y0 = w.y0, y1 = w.y1;
  const Rational x = x0 + (pixel.column + Rational(1, 2)) * (x1 - x0) / grid.width;
  const Rational y = y1 - (pixel.row + Rational(1, 2)) * (y1 - y0) / grid.height;
  const auto along = [&](double f, double r, double u) { return Rational(f + x * r + y * u); };
  const Rational d[3] = {along(frame.forward.x, frame.right.x, frame.up.x),
                         along(frame.forward.y, frame.right.y, frame.up.y),
                         along(frame.forward.z, frame.right.z, frame.up.z)};
  Integer all = lcm(d[0].get_den(), lcm(d[1].get_den(), d[2].get_den()));
  const auto cleared = [&](const Rational& v) { return Integer(v.get_num() * (all / v.get_den())); };
  return {cleared(d[0]), cleared(d[1]), cleared(d[2])};
}

/// Adds one pixel to what is known of each primitive.
void count(const ExactSights& pixel, std::map<PrimitiveId, ExactSeen>& seen) {
  std::set<PrimitiveId> here;
  for (const ExactSight& sight : pixel.sights) {
    for (const PrimitiveId id : sight.visible) {
      ExactSeen& s = seen[id];
      s.primitive = id;
      s.length += sight.to - sight.from;
      ++s.sights;
      if (here.insert(id).second) ++s.pixels;
    }
  }
}

Rational middle(const Rational& a, const Rational& b) { return (a + b) / 2; }

}  // namespace

SegmentOracle::SegmentOracle(const SceneArrays& scene, const SegmentView& view, SegmentPlant plant)
    : view_(view), plant_(plant), scale_(scale_of(scene, view)) {
  if (!scene.spheres.empty()) throw std::logic_error("the oracle takes no spheres");
  from_ = scale_(view.from);
  to_ = scale_(view.to);
  surfaces_ = surfaces_of(scene, scale_);
  const auto holds = [](const Surface& s, const Integer3& p) { return dot(s.normal, p - s.corner[0]) == 0; };
  for (const Surface& s : surfaces_) {
    if (from_ != to_ && s.occludes && holds(s, from_) && holds(s, to_)) floors_.push_back(s);
  }
}

SegmentOracle::Path SegmentOracle::path(const Pixel& pixel) const {
  const Frame& frame = view_.frames.at(static_cast<std::size_t>(pixel.frame));
  return {from_, to_, centre(frame, view_.pixels, pixel)};
}

ExactRay SegmentOracle::Path::ray(const Rational& t) const {
  const Integer &p = t.get_num(), &q = t.get_den(), rest = q - p;
  return {rest * from + p * to, q, direction};
}

// Why nothing changes between two events. The eye is affine in t, the direction is fixed. Whether a surface
// is hit, from which side and inside or not, hangs on the signs of four numbers that are affine in the eye:
// `away` and the three of its edges (`across` does not change). The order of two surfaces that are both hit
// hangs on the sign of the difference of their distances, away / across, affine as well. An affine function
// either vanishes everywhere, or has one root and keeps its sign on either side of it. All those roots are
// events.

std::vector<Rational> SegmentOracle::own_events(const Surface& surface, const Path& path) const {
  const HitNumbers at_0 = numbers(surface, path.ray(0)), at_1 = numbers(surface, path.ray(1));
  std::vector<Rational> found;
  const auto add = [&](const std::optional<Rational>& t) {
    if (t) found.push_back(*t);
  };
  if (plant_ != SegmentPlant::forget_camera_event) add(root(at_0.away, at_1.away));
  for (std::size_t k = 0; k < 3; ++k) add(root(at_0.edge[k], at_1.edge[k]));
  return found;
}

/// Whether one of the affine numbers is against a hit at both ends, and so at all times between them.
bool SegmentOracle::is_missed(const Surface& surface, const Path& path) const {
  const HitNumbers at_0 = numbers(surface, path.ray(0)), at_1 = numbers(surface, path.ray(1));
  const auto ahead = [](const HitNumbers& n) { return sgn(n.away) * sgn(n.across) > 0; };
  if (!ahead(at_0) && !ahead(at_1)) return true;
  for (std::size_t k = 0; k < 3; ++k) {
    if (at_0.edge[k] < 0 && at_1.edge[k] < 0) return true;
  }
  return false;
}

/// The surfaces that are hit for some time. All others are hit at single events at most, where R10 does not
/// look.
SegmentOracle::Surfaces SegmentOracle::met(const Path& path) const {
  Surfaces found;
  for (const Surface& s : surfaces_) {
    if (is_missed(s, path)) continue;
    const std::vector<Rational> parts = in_order(own_events(s, path));
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
      if (!hit(s, path.ray(middle(parts[i], parts[i + 1])))) continue;
      found.push_back(&s);
      break;
    }
  }
  return found;
}

std::vector<Rational> SegmentOracle::events(const Surfaces& met, const Path& path) const {
  std::vector<Rational> found;
  for (const Surface* s : met) {
    const std::vector<Rational> own = own_events(*s, path);
    found.insert(found.end(), own.begin(), own.end());
  }
  if (plant_ == SegmentPlant::forget_crossings) return in_order(std::move(found));
  const ExactRay ray_0 = path.ray(0), ray_1 = path.ray(1);
  const auto lead = [](const Surface& a, const Surface& b, const ExactRay& r) {
    const HitNumbers p = numbers(a, r), q = numbers(b, r);
    return Integer(p.away * q.across - q.away * p.across);
  };
  for (auto a = met.begin(); a != met.end(); ++a) {
    for (auto b = std::next(a); b != met.end(); ++b) {
      const std::optional<Rational> t = root(lead(**a, **b, ray_0), lead(**a, **b, ray_1));
      if (!t) continue;
      // Planes that cross beside one of the surfaces swap nothing: there, and until the next event, that
      // surface is not hit.
      const ExactRay there = path.ray(*t);
      if (hit(**a, there) && hit(**b, there)) found.push_back(*t);
    }
  }
  return in_order(std::move(found));
}

std::vector<Rational> SegmentOracle::in_order(std::vector<Rational> events) const {
  events.push_back(0);
  events.push_back(1);
  std::sort(events.begin(), events.end());
  const auto same = [&](const Rational& a, const Rational& b) {
    return plant_ == SegmentPlant::use_an_epsilon ? b - a < Rational(1e-9) : a == b;
  };
  events.erase(std::unique(events.begin(), events.end(), same), events.end());
  return events;
}

Look SegmentOracle::look(const Surfaces& met, const ExactRay& ray) const {
  std::vector<ExactHit> hits;
  for (const Surface* s : met) {
    if (std::optional<ExactHit> h = hit(*s, ray)) hits.push_back(std::move(*h));
  }
  const auto nearest = [&] {
    const ExactHit* least = nullptr;
    for (const ExactHit& h : hits) {
      if (h.surface->occludes && (least == nullptr || h.distance < least->distance)) least = &h;
    }
    return least;
  };
  if (plant_ == SegmentPlant::drop_an_occluder && nearest() != nullptr)
    hits.erase(hits.begin() + (nearest() - hits.data()));

  Look found;
  if (const ExactHit* first = nearest()) found.nearest = first->distance;
  for (const ExactHit& h : hits) {
    const bool hidden = std::any_of(hits.begin(), hits.end(), [&](const ExactHit& other) {
      if (!other.surface->occludes || &other == &h) return false;
      return other.distance < h.distance ||
             (plant_ == SegmentPlant::flip_a_tie && other.distance == h.distance);
    });
    if (hidden) continue;
    found.visible.push_back(h.surface->id);
    const bool alone = std::all_of(hits.begin(), hits.end(), [&](const ExactHit& other) {
      return !other.surface->occludes || other.distance > h.distance ||
             h.surface->is_coplanar_with(*other.surface);
    });
    if (h.inside && alone) found.proper.push_back(h.surface->id);
  }
  return found;
}

std::vector<Rational> SegmentOracle::events(const Pixel& pixel) const {
  const Path along = path(pixel);
  std::vector<Rational> found = events(met(along), along);
  // What is hit at a single moment is no part of any sight, but a ray at that moment meets it.
  for (const Surface& s : surfaces_) {
    const std::vector<Rational> own = own_events(s, along);
    found.insert(found.end(), own.begin(), own.end());
  }
  return in_order(std::move(found));
}

Look SegmentOracle::look(const Pixel& pixel, const Rational& t) const {
  Surfaces all;
  for (const Surface& s : surfaces_) all.push_back(&s);
  Look found = look(all, path(pixel).ray(t));
  mpq_div_2exp(found.nearest.get_mpq_t(), found.nearest.get_mpq_t(),
               static_cast<mp_bitcnt_t>(scale_.exponent()));
  return found;
}

bool SegmentOracle::on_occluder(const Rational& t) const {
  const ExactRay from_there = path({}).ray(t);
  return std::any_of(surfaces_.begin(), surfaces_.end(),
                     [&](const Surface& s) { return s.occludes && starts_on(s, from_there); });
}

std::vector<Rational> SegmentOracle::borders_of(const Surface& s) const {
  std::vector<Rational> found;
  for (std::size_t k = 0; k < 3; ++k) {
    const Integer3 inwards = cross(s.normal, s.corner[(k + 1) % 3] - s.corner[k]);
    const auto side = [&](const Integer3& p) { return Integer(dot(inwards, p - s.corner[k])); };
    if (const std::optional<Rational> t = root(side(from_), side(to_))) found.push_back(*t);
  }
  return found;
}

ExactSights SegmentOracle::sights(const Pixel& pixel, std::set<PrimitiveId>* proper) const {
  const Path along = path(pixel);
  const Surfaces surfaces = met(along);
  std::vector<Rational> borders = events(surfaces, along);
  for (const Surface& floor : floors_) {
    for (Rational& t : borders_of(floor)) borders.push_back(std::move(t));
  }
  borders = in_order(std::move(borders));
  ExactSights found{pixel.frame, pixel.column, pixel.row, {}};
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const Rational t = middle(borders[i], borders[i + 1]);
    const ExactRay ray = along.ray(t);
    Look seen = look(surfaces, ray);
    const bool grounded = std::any_of(floors_.begin(), floors_.end(),
                                      [&](const Surface& floor) { return starts_on(floor, ray); });
    if (proper != nullptr && !grounded) proper->insert(seen.proper.begin(), seen.proper.end());
    if (!found.sights.empty() && found.sights.back().visible == seen.visible) {
      found.sights.back().to = borders[i + 1];
    } else {
      found.sights.push_back({borders[i], borders[i + 1], std::move(seen.visible)});
    }
  }
  return found;
}

SegmentAnswer SegmentOracle::answer() const {
  SegmentAnswer answer;
  std::set<PrimitiveId> proper;
  std::map<PrimitiveId, ExactSeen> seen;
  for_pixels(view_, [&](const Pixel& pixel) {
    answer.pixels.push_back(sights(pixel, &proper));
    count(answer.pixels.back(), seen);
  });
  for (auto& [id, s] : seen) {
    answer.visible.push_back(id);
    if (proper.count(id) == 0) answer.boundary.push_back(id);
    answer.seen.push_back(s);
  }
  return answer;
}

}  // namespace provis::test
