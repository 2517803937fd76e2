#include "src/segment/witnesses.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>

#include "predicates/environment.hpp"
#include "predicates/exact_number.hpp"
#include "predicates/interval.hpp"
#include "predicates/rational.hpp"
#include "provis/error.hpp"
#include "src/point/dyadic.hpp"
#include "src/scene/parallel.hpp"
#include "src/segment/frustum.hpp"

namespace provis {
namespace {

/// A dyadic moment, and an interval around it.
struct Moment {
  ExactTime exact;
  Interval bounds;

  explicit Moment(const ExactTime& t) : exact(t), bounds(CGAL::to_interval(t)) {}
};

/// The sign of a formula over (number type, moment): of the interval where it has one.
template <class Formula>
Sign certain(const Moment& t, const Formula& formula) {
  if (const auto s = sign_of(formula(t.bounds))) return *s;
  return sign_of(formula(t.exact));
}

template <class N>
N at_time(const Linear<N>& f, const N& t) {
  return f.at_zero - t * f.slope;
}

/// floor(x 2^bits) / 2^bits
ExactTime rounded_down(const ExactTime& x, unsigned bits) {
  CGAL::Gmpz n, d;
  mpz_mul_2exp(n.mpz(), x.numerator().mpz(), bits);
  mpz_fdiv_q(n.mpz(), n.mpz(), x.denominator().mpz());
  mpz_ui_pow_ui(d.mpz(), 2, bits);
  return ExactTime(n, d);
}

/// Strictly inside, and another one in each attempt: only finitely many moments of a glimpse prove nothing.
ExactTime moment_inside(const Glimpse& g, unsigned attempt) {
  // 1/2, 1/3, 2/3, 1/4, ...: no moment twice before rounding.
  unsigned parts = 2, part = attempt + 1;
  while (part >= parts) part -= parts++ - 1;
  const ExactTime target =
      g.begin + (g.end - g.begin) * ExactTime(static_cast<int>(part), static_cast<int>(parts));
  for (unsigned bits = attempt;; ++bits) {
    const ExactTime t = rounded_down(target, bits);
    if (g.begin < t && t < g.end) return t;
  }
}

/// Looks along one frame's pixels at single moments.
class Look {
 public:
  Look(const Scene& scene, const ClusterTree& tree, const PathGeometry& path, double reach)
      : scene_(scene), tree_(tree), path_(path), projection_(path, reach) {}

  const PathGeometry& path() const { return path_; }

  /// Whether the ray is a proof that the triangle is visible, viewpoints on occluders aside (R11).
  bool proves(PrimitiveId target, const Pixel& at, const Moment& t) const {
    const Sign side = side_of(target, at, t);
    if (!hit(target, at, t, side, true)) return false;
    const double when = CGAL::to_double(t.exact);
    const Frustum ray(projection_, path_, {at.column, at.row, 1, 1}, {when, when});
    return free(ray, tree_.levels() - 1, 0, [&](PrimitiveId o) { return blocks(o, target, side, at, t); });
  }

 private:
  Corners corners(PrimitiveId t) const {
    return {{&scene_.corner(t, 0), &scene_.corner(t, 1), &scene_.corner(t, 2)}};
  }

  Sign side_of(PrimitiveId id, const Pixel& at, const Moment& t) const {
    return certain(t, [&]<class N>(const N&) { return along<N>(path_, at, corners(id)); });
  }

  /// Whether the triangle is hit, if need be in its relative interior.
  bool hit(PrimitiveId id, const Pixel& at, const Moment& t, Sign side, bool inner) const {
    if (side == Sign::zero || (side == Sign::positive && (scene_.triangle_flags()[id] & single_sided)))
      return false;
    for (int k = 0; k < 3; ++k) {
      const Sign s = certain(t, [&]<class N>(const N& n) {
        return at_time(edge_motion<N>(path_, at, scene_.corner(id, k), scene_.corner(id, (k + 1) % 3)), n);
      });
      if (s == -side || (inner && s == Sign::zero)) return false;
    }
    return certain(t, [&]<class N>(const N& n) { return at_time(reach_motion<N>(path_, corners(id)), n); }) ==
           side;
  }

  bool blocks(PrimitiveId id, PrimitiveId target, Sign target_side, const Pixel& at, const Moment& t) const {
    if (id == target || (scene_.triangle_flags()[id] & see_through)) return false;
    const Sign side = side_of(id, at, t);
    if (!hit(id, at, t, side, false)) return false;
    const Sign farther = certain(t, [&]<class N>(const N& n) {
      return at_time(depth_motion<N>(path_, at, corners(id), corners(target)), n);
    });
    return farther * side * target_side != Sign::positive && !coplanar(id, target);
  }

  bool coplanar(PrimitiveId a, PrimitiveId b) const {
    using N = ExactNumber;
    const Vec3<N> o = numbers<N>(scene_.corner(a, 0));
    const Vec3<N> n = cross(numbers<N>(scene_.corner(a, 1)) - o, numbers<N>(scene_.corner(a, 2)) - o);
    const auto on = [&](int k) { return sign_of(dot(n, numbers<N>(scene_.corner(b, k)) - o)) == Sign::zero; };
    return on(0) && on(1) && on(2);
  }

  template <class Blocks>
  bool free(const Frustum& ray, std::uint32_t level, std::uint32_t cluster, const Blocks& blocks) const {
    if (ray.touched(tree_.box(level, cluster)).empty()) return true;
    bool is_free = true;
    if (level == 0) {
      tree_.for_triangles(cluster, [&](PrimitiveId t) {
        const Corners c = corners(t);
        if (is_free && !ray.touched(*c.p[0], *c.p[1], *c.p[2]).empty() && blocks(t)) is_free = false;
      });
      return is_free;
    }
    for (const std::uint32_t child : {2 * cluster, 2 * cluster + 1})
      if (child < tree_.size(level - 1) && !free(ray, level - 1, child, blocks)) return false;
    return true;
  }

  const Scene& scene_;
  const ClusterTree& tree_;
  PathGeometry path_;
  PathProjection projection_;
};

Witness witness_at(PrimitiveId id, const Look& look, const Pixel& at, const ExactTime& t) {
  const PathGeometry& path = look.path();
  const auto exact = [](const Vec3d& v) { return numbers<ExactTime>(v); };
  const Vec3<ExactTime> v = exact(path.from) + t * (exact(path.to) - exact(path.from));
  const Vec3<ExactTime> d = pixel_direction<ExactTime>(path, at);
  return {id, dyadic(v), dyadic(d)};
}

}  // namespace

std::vector<Witness> make_witnesses(const Scene& scene, const SegmentView& view, const ClusterTree& tree,
                                    const BlockedTimes& blocked,
                                    const std::map<PrimitiveId, FrameGlimpse>& glimpses,
                                    const Context& context) {
  const double reach = std::max({tree.reach(), largest(view.from), largest(view.to)});
  std::vector<Look> looks;
  for (const Frame& f : view.frames)
    looks.emplace_back(scene, tree, PathGeometry{view.from, view.to, f, view.pixels}, reach);
  const std::vector<std::pair<PrimitiveId, FrameGlimpse>> list(glimpses.begin(), glimpses.end());
  std::vector<Witness> witnesses(list.size());
  parallel_for(list.size(), [&](std::size_t k) {
    if (context.cancelled()) throw Error(Error::Code::cancelled, "segment", "interrupted");
    const RoundUp guard;
    const auto& [id, seen] = list[k];
    const Look& look = looks[static_cast<std::size_t>(seen.frame)];
    constexpr unsigned most_attempts = 1u << 16;
    for (unsigned attempt = 0;; ++attempt) {
      if (attempt == most_attempts)
        throw Error(Error::Code::internal, "witness",
                    "a glimpse that shows nothing of primitive " + std::to_string(id));
      const Moment t(moment_inside(seen.glimpse, attempt));
      if (blocked.at(t.exact) || !look.proves(id, seen.glimpse.at, t)) continue;
      witnesses[k] = witness_at(id, look, seen.glimpse.at, t.exact);
      return;
    }
  });
  return witnesses;
}

}  // namespace provis
