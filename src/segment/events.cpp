#include "src/segment/events.hpp"

#include "predicates/interval.hpp"
#include "predicates/zero_area.hpp"
#include "src/segment/exact_event.hpp"
#include "src/segment/sign_check.hpp"

namespace provis {
namespace {

constexpr double bound_slack = 1 + 0x1p-20;

/// How well an approximation has to be known before exact numbers are asked for a better one.
constexpr double fine = 0x1p-40;

struct Approximation {
  double value = 0, error = HUGE_VAL;
};

Approximation approximation(double inf, double sup) {
  const double middle = inf / 2 + sup / 2;
  return {middle, std::max(sup - middle, middle - inf) * bound_slack + std::fabs(middle) * 4 * unit_roundoff};
}

Approximation quotient(const Interval& p, const Interval& q) {
  if (!(q.inf() > 0 || q.sup() < 0)) return {};
  const Interval t = p / q;
  return approximation(t.inf(), t.sup());
}

}  // namespace

template <Arithmetic A>
Events<A>::Events(const PathGeometry& path, SignCounts& counts) : signs_(path, counts) {
  if (A == Arithmetic::doubles && path.checked) check_ = std::make_unique<SignCheck>(path);
}

template <Arithmetic A>
Events<A>::~Events() = default;

template <Arithmetic A>
std::uint32_t Events<A>::add(MovingFacet facet) {
  if (check_) check_->add(facet);
  facets_.push_back(facet);
  return static_cast<std::uint32_t>(facets_.size() - 1);
}

template <Arithmetic A>
void Events<A>::clear() {
  if (check_) check_->clear();
  facets_.clear();
  memory_.clear();
}

template <Arithmetic A>
Motion Events<A>::motion(const Event& e) const {
  switch (e.kind) {
    case EventKind::edge_0:
    case EventKind::edge_1:
    case EventKind::edge_2:
      return {MotionKind::edge, 0, facets_[e.facet].edges[static_cast<int>(e.kind)], {}};
    case EventKind::plane:
      return {MotionKind::reach, 0, facets_[e.facet].corners, {}};
    case EventKind::crossing:
      return {MotionKind::depth, 0, facets_[e.facet].corners, facets_[e.other].corners};
    case EventKind::time:
      break;
  }
  return {MotionKind::time, e.t, {}, {}};
}

template <Arithmetic A>
std::optional<Span> Events<A>::span(const Pixel& at, const Centre& centre, std::uint32_t facet,
                                    const TimeRange& range) {
  if constexpr (filtered) {
    Span s;
    const Look look = quick_span(centre, facet, range, s);
    if (look != Look::unclear) {
      signs_.count(Predicate::motion, Tier::filter);
      if constexpr (A == Arithmetic::doubles)
        if (check_ && check_->wrong_span(at, centre, facet, range, look == Look::hit ? &s : nullptr))
          signs_.count_wrong(Predicate::motion);
    }
    if (look == Look::hit) return s;
    if (look == Look::miss) return std::nullopt;
  }
  return slow_span(at, facet, range);
}

/// Float64 with the bounds of ERRORS.md, 9. Unclear where a function may vanish at an end of the range, or
/// where two events cannot be told apart.
template <Arithmetic A>
typename Events<A>::Look Events<A>::quick_span(const Centre& c, std::uint32_t facet, const TimeRange& range,
                                               Span& span) const {
  const MovingFacet& f = facets_[facet];
  const double n = f.along.at(c.x, c.y), off = doubt(f.along.error);
  if (!(std::fabs(n) > off)) return Look::unclear;
  const bool back = n > 0;
  if (back && f.single_sided) return Look::miss;
  span.begin = moment(range.begin);
  span.end = moment(range.end);
  bool clear = true;
  // A function that has to be positive, after multiplication by the orientation.
  const auto limit = [&](EventKind kind, double p, double q, double p_error, double q_error, bool turned) {
    const double error =
        doubt((p_error + q_error + 4 * unit_roundoff * (std::fabs(p) + std::fabs(q))) * slack);
    const double o = back != turned ? 1 : -1;
    const double first = o * (p - range.begin * q), last = o * (p - range.end * q);
    if (first < -error && last < -error) return false;
    if (first > error && last > error) return true;
    const bool ends = first > error && last < -error, begins = first < -error && last > error;
    if (!(ends || begins) || !(std::fabs(q) > 2 * q_error)) {
      clear = false;
      return true;
    }
    const double t = p / q;
    const double t_error = doubt(
        ((p_error + std::fabs(t) * q_error) / (std::fabs(q) - q_error) + 4 * unit_roundoff * std::fabs(t)) *
            slack +
        underflow_bound);
    Event& end = ends ? span.end : span.begin;
    const double gain = ends ? end.t - t : t - end.t, unsure = (end.error + t_error) * slack;
    if (end.kind == EventKind::time || gain > unsure) {
      end = {t, t_error, facet, no_facet, kind, q > 0 ? Sign::positive : Sign::negative};
    } else if (!(gain < -unsure)) {
      clear = false;
    }
    return true;
  };
  for (int k = 0; k < 3; ++k) {
    const MotionFunction& e = f.edge[k];
    if (!limit(static_cast<EventKind>(k), e.at_zero.at(c.x, c.y), e.slope.at(c.x, c.y), e.at_zero.error,
               e.slope.error, f.turned[k]))
      return Look::miss;
  }
  if (!limit(EventKind::plane, f.reach_at_zero.value, f.reach_slope.value, f.reach_at_zero.radius,
             f.reach_slope.radius, false))
    return Look::miss;
  const double length = span.end.t - span.begin.t, unsure = (span.end.error + span.begin.error) * slack;
  if (length < -unsure) return Look::miss;
  if (!clear || !(length > unsure)) return Look::unclear;

  Shown& s = span.shown;
  s = {facet,
       back ? Sign::positive : Sign::negative,
       false,
       f.reach_at_zero.value / n,
       f.reach_slope.value / n,
       0};
  const double size = std::fabs(s.depth_at_zero) + std::fabs(s.depth_slope);
  s.depth_error = doubt(((f.reach_at_zero.radius + f.reach_slope.radius + size * off) / (std::fabs(n) - off) +
                         16 * unit_roundoff * size) *
                            slack +
                        underflow_bound);
  return Look::hit;
}

template <Arithmetic A>
std::optional<Span> Events<A>::slow_span(const Pixel& at, std::uint32_t facet, const TimeRange& range) {
  const MovingFacet& f = facets_[facet];
  Span span{moment(range.begin), moment(range.end), {}};
  span.shown.facet = facet;
  span.shown.side = signs_.along(at, f.corners);
  if (span.shown.side == Sign::zero || (span.shown.side == Sign::positive && f.single_sided))
    return std::nullopt;
  for (const EventKind kind : {EventKind::plane, EventKind::edge_0, EventKind::edge_1, EventKind::edge_2}) {
    Event e{0, HUGE_VAL, facet, no_facet, kind, Sign::zero};
    const bool plane = kind == EventKind::plane;
    const Sign wanted = !plane && f.turned[static_cast<int>(kind)] ? -span.shown.side : span.shown.side;
    const Motion m = motion(e);
    e.slope = signs_.slope(at, m);
    if (e.slope == Sign::zero) {
      const Sign always = signs_.at_zero(at, m);
      if (always == -wanted || (plane && always == Sign::zero)) return std::nullopt;
      if (always == Sign::zero) span.shown.on_edge = true;
      continue;
    }
    place(at, e);
    if (e.slope == wanted) {
      if (compare(at, e, span.end) == Sign::negative) span.end = e;
    } else if (compare(at, e, span.begin) == Sign::positive) {
      span.begin = e;
    }
  }
  if (compare(at, span.begin, span.end) != Sign::negative) return std::nullopt;
  set_depth(at, span.shown);
  return span;
}

/// The event's time: from intervals, and where they are too wide from exact numbers.
template <Arithmetic A>
void Events<A>::place(const Pixel& at, Event& e) const {
  if constexpr (A == Arithmetic::doubles) {
    const Linear<double> f = evaluate<double>(path(), at, motion(e));
    e.t = f.at_zero / f.slope;
    e.error = 0;
  } else {
    const Motion m = motion(e);
    const Linear<Interval> f = evaluate<Interval>(path(), at, m);
    Approximation a = quotient(f.at_zero, f.slope);
    if (!(a.error < fine)) {
      const auto [inf, sup] = CGAL::to_interval(exact_root(path(), at, m));
      a = approximation(inf, sup);
    }
    e.t = a.value;
    e.error = filtered ? a.error : HUGE_VAL;
  }
}

template <Arithmetic A>
void Events<A>::set_depth(const Pixel& at, Shown& s) const {
  // The direction is 4 W H times the one of float64 numbers, and so is `along`.
  const double scale = 4.0 * path().pixels.width * path().pixels.height;
  const Corners& c = facets_[s.facet].corners;
  if constexpr (A == Arithmetic::doubles) {
    const Linear<double> r = reach_motion<double>(path(), c);
    const double n = along<double>(path(), at, c) / scale;
    s.depth_at_zero = r.at_zero / n;
    s.depth_slope = r.slope / n;
    s.depth_error = 0;
  } else {
    const Linear<Interval> r = reach_motion<Interval>(path(), c);
    const Interval n = along<Interval>(path(), at, c) / Interval(scale);
    const Approximation zero = quotient(r.at_zero, n), slope = quotient(r.slope, n);
    s.depth_at_zero = zero.value;
    s.depth_slope = slope.value;
    s.depth_error = filtered ? (zero.error + slope.error +
                                16 * unit_roundoff * (std::fabs(zero.value) + std::fabs(slope.value))) *
                                   slack
                             : HUGE_VAL;
  }
}

template <Arithmetic A>
Sign Events<A>::slow_compare(const Pixel& at, const Event& a, const Event& b) {
  if (a.kind == EventKind::time && b.kind == EventKind::time) return sign_of(a.t - b.t);
  if (const auto s = known_order(a, b)) {
    signs_.count(Predicate::event_order, Tier::structure);
    return *s;
  }
  return signs_.order(at, motion(a), motion(b)) * a.slope * b.slope;
}

template <Arithmetic A>
Sign Events<A>::slow_compare_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when) {
  if (a.facet == b.facet || meet_at(when, a.facet, b.facet)) {
    signs_.count(Predicate::event_order, Tier::structure);
    return Sign::zero;
  }
  const Motion depth{MotionKind::depth, 0, facets_[a.facet].corners, facets_[b.facet].corners};
  return signs_.order(at, depth, motion(when)) * when.slope * a.side * b.side;
}

template <Arithmetic A>
Event Events<A>::restated(const Pixel& at, const Event& e) {
  if (e.kind == EventKind::time) return e;
  Event same = e;
  same.error = HUGE_VAL;
  same.slope = signs_.slope(at, motion(e));
  return same;
}

template <Arithmetic A>
Shown Events<A>::restated(const Pixel& at, const Shown& s) {
  return {s.facet, signs_.along(at, facets_[s.facet].corners), s.on_edge, 0, 0, HUGE_VAL};
}

template <Arithmetic A>
void Events<A>::watch_order(const Pixel& at, const Event& a, const Event& b, Sign taken) {
  if (check_->wrong_order(at, a, b, taken)) signs_.count_wrong(Predicate::event_order);
}

template <Arithmetic A>
void Events<A>::watch_depth(const Pixel& at, const Shown& a, const Shown& b, const Event& when, Sign taken) {
  if (check_->wrong_depth(at, a, b, when, taken)) signs_.count_wrong(Predicate::event_order);
}

template <Arithmetic A>
Event Events<A>::crossing(const Pixel& at, const Shown& a, const Shown& b, Sign first) {
  Event e{0, HUGE_VAL, a.facet, b.facet, EventKind::crossing, first * a.side * b.side};
  if constexpr (filtered) {
    // At the true crossing the approximate distances differ by no more than their errors.
    const double slope = a.depth_slope - b.depth_slope;
    e.t = (a.depth_at_zero - b.depth_at_zero) / slope;
    e.error = doubt(
        ((a.depth_error + b.depth_error) / std::fabs(slope) + 8 * unit_roundoff * std::fabs(e.t)) * slack);
    if (e.error < fine) return e;
  }
  place(at, e);
  return e;
}

/// Zero where structure says that both are the same moment.
template <Arithmetic A>
std::optional<Sign> Events<A>::known_order(const Event& a, const Event& b) {
  if (a.kind == EventKind::time || b.kind == EventKind::time) return std::nullopt;
  const auto edge = [](const Event& e) { return e.kind <= EventKind::edge_2; };
  bool same = false;
  if (edge(a) && edge(b)) {
    same = same_line(a.facet, static_cast<int>(a.kind), b.facet, static_cast<int>(b.kind));
  } else if (a.kind == EventKind::crossing && edge(b)) {
    same = meet_at(b, a.facet, a.other);
  } else if (edge(a) && b.kind == EventKind::crossing) {
    same = meet_at(a, b.facet, b.other);
  } else if (a.kind == EventKind::crossing && b.kind == EventKind::crossing) {
    same = (a.facet == b.facet && a.other == b.other) || (a.facet == b.other && a.other == b.facet);
  } else if (a.kind == EventKind::plane && b.kind == EventKind::plane) {
    same = coplanar(a.facet, b.facet);
  }
  return same ? std::optional(Sign::zero) : std::nullopt;
}

/// Whether structure says that the ray meets both planes in one point at the event.
template <Arithmetic A>
bool Events<A>::meet_at(const Event& when, std::uint32_t a, std::uint32_t b) {
  if (when.kind <= EventKind::edge_2) {
    const int k = static_cast<int>(when.kind);
    if (edge_in_plane(when.facet, k, a) && edge_in_plane(when.facet, k, b)) return true;
  } else if (when.kind == EventKind::crossing &&
             ((when.facet == a && when.other == b) || (when.facet == b && when.other == a))) {
    return true;
  }
  return coplanar(a, b);
}

template <Arithmetic A>
template <class Decide>
bool Events<A>::remembered(std::uint64_t kind, std::uint64_t a, std::uint64_t b, const Decide& decide) {
  const std::uint64_t key = kind << 62 | a << 31 | b;
  const auto found = memory_.find(key);
  if (found != memory_.end()) return found->second;
  const bool answer = decide();
  memory_.emplace(key, answer);
  return answer;
}

template <Arithmetic A>
bool Events<A>::in_plane(const Vec3d& p, std::uint32_t facet) {
  const Corners& c = facets_[facet].corners;
  return p == *c.p[0] || p == *c.p[1] || p == *c.p[2] || signs_.height(p, c) == Sign::zero;
}

template <Arithmetic A>
bool Events<A>::edge_in_plane(std::uint32_t owner, int edge, std::uint32_t facet) {
  if (owner == facet) return true;
  const Corners& e = facets_[owner].edges[edge];
  return remembered(0, std::uint64_t{owner} * 4 + static_cast<std::uint64_t>(edge), facet,
                    [&] { return in_plane(*e.p[0], facet) && in_plane(*e.p[1], facet); });
}

template <Arithmetic A>
bool Events<A>::coplanar(std::uint32_t a, std::uint32_t b) {
  if (a == b) return true;
  if (b < a) std::swap(a, b);
  const Corners& c = facets_[b].corners;
  return remembered(1, a, b,
                    [&] { return in_plane(*c.p[0], a) && in_plane(*c.p[1], a) && in_plane(*c.p[2], a); });
}

template <Arithmetic A>
bool Events<A>::same_line(std::uint32_t a, int edge_a, std::uint32_t b, int edge_b) {
  const Corners &e = facets_[a].edges[edge_a], &f = facets_[b].edges[edge_b];
  if (*e.p[0] == *f.p[0] && *e.p[1] == *f.p[1]) return true;
  std::uint64_t first = std::uint64_t{a} * 4 + static_cast<std::uint64_t>(edge_a),
                second = std::uint64_t{b} * 4 + static_cast<std::uint64_t>(edge_b);
  if (second < first) std::swap(first, second);
  return remembered(2, first, second, [&] {
    return zero_area(*e.p[0], *e.p[1], *f.p[0]) && zero_area(*e.p[0], *e.p[1], *f.p[1]);
  });
}

template class Events<Arithmetic::doubles>;
template class Events<Arithmetic::chain>;
template class Events<Arithmetic::mpfr>;
template class Events<Arithmetic::exact>;

}  // namespace provis
