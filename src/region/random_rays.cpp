#include "src/region/random_rays.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"
#include "predicates/on_triangle.hpp"
#include "predicates/plane_side.hpp"
#include "src/point/dyadic.hpp"
#include "src/scene/finite.hpp"

namespace provis {

/// Two float64 points, taken as exact.
struct RandomRays::Ray : CertainRay<ExactNumber> {
  Ray(const Vec3d& from, const Vec3d& way)
      : CertainRay{numbers<ExactNumber>(from), numbers<ExactNumber>(way), numbers<Interval>(from),
                   numbers<Interval>(way)},
        start(from),
        towards(way) {}

  Vec3d start, towards;
};

namespace {

/// In the closed range, and at its ends as often as between them: what is seen from a box at all is mostly
/// seen from its surface.
double any_between(double lo, double hi, Random& random) {
  const double share = 2 * random.unit() - 0.5;
  if (share <= 0) return lo;
  if (share >= 1) return hi;
  return std::clamp(lo * (1 - share) + hi * share, lo, hi);
}

/// Near corners and edges more often than an even spread would be: little is seen of what is hard to see.
Vec3d any_point(const Vec3d& a, const Vec3d& b, const Vec3d& c, Random& random) {
  const auto weight = [&] {
    const double u = random.unit();
    return u * u * u + 0x1p-30;
  };
  const double u = weight(), v = weight(), w = weight(), all = u + v + w;
  return (u / all) * a + (v / all) * b + (w / all) * c;
}

}  // namespace

RandomRays::RandomRays(const Scene& scene, const ViewCell& cell) : scene_(scene), cell_(cell), tree_(scene) {
  if (cell.window) geometry_ = make_geometry(cell.lower, *cell.window, false);
}

std::optional<Witness> RandomRays::aim_at(PrimitiveId id, int rays, std::uint64_t seed) const {
  Random random(seed, id);
  for (int k = 0; k < rays; ++k) {
    const auto [start, towards] = any_ray(id, random);
    if (const auto witness = prove(id, start, towards)) return witness;
  }
  return std::nullopt;
}

std::optional<Witness> RandomRays::from_close_by(PrimitiveId id) const {
  const RoundNearest guard;
  const Vec3d &a = scene_.corner(id, 0), &b = scene_.corner(id, 1), &c = scene_.corner(id, 2);
  const Vec3d n = cross(b - a, c - a);
  const double length = std::sqrt(dot(n, n)), size = std::sqrt(length);
  if (!(length > 0)) return std::nullopt;
  const Box box{cell_.lower, cell_.upper};
  constexpr int steps = 8;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; i + j < steps; ++j) {
      const Vec3d target = a + ((i + 0.31) / steps) * (b - a) + ((j + 0.37) / steps) * (c - a);
      for (const double side : {0x1p-8, -0x1p-8, 0x1p-20, -0x1p-20}) {
        const Vec3d start = target + (side * size / length) * n;
        if (!meet(box, {start, start})) continue;
        if (const auto witness = prove(id, start, target - start)) return witness;
      }
    }
  return std::nullopt;
}

std::optional<Witness> RandomRays::prove(PrimitiveId id, const Vec3d& start, const Vec3d& towards) const {
  if (!finite(towards)) return std::nullopt;  // farther apart than numbers reach
  const RoundUp guard;
  const Ray ray(start, towards);
  if (!hits(ray, id) || !in_window(towards) || blocked(ray, id) || on_occluder(start)) return std::nullopt;
  return Witness{id, dyadic(ray.origin), dyadic(ray.direction)};
}

/// Start and direction.
std::pair<Vec3d, Vec3d> RandomRays::any_ray(PrimitiveId id, Random& random) const {
  const RoundNearest guard;
  const Vec3d &lo = cell_.lower, &hi = cell_.upper;
  const Vec3d start{any_between(lo.x, hi.x, random), any_between(lo.y, hi.y, random),
                    any_between(lo.z, hi.z, random)};
  return {start, any_point(scene_.corner(id, 0), scene_.corner(id, 1), scene_.corner(id, 2), random) - start};
}

/// The sign of n·direction where the ray reaches the plane of the triangle beyond its start, from a side that
/// the triangle has; a plane that holds the start has no hits (R6).
std::optional<Sign> RandomRays::reaches(RaySigns<ExactNumber>& signs, PrimitiveId t) const {
  const Sign along = signs.along();
  if (along == Sign::zero || signs.reach() != along) return std::nullopt;
  if ((scene_.triangle_flags()[t] & single_sided) && along != Sign::negative) return std::nullopt;
  return along;
}

RaySigns<ExactNumber> RandomRays::signs(const Ray& ray, PrimitiveId t) const {
  return {ray, scene_.corner(t, 0), scene_.corner(t, 1), scene_.corner(t, 2)};
}

/// In the relative interior.
bool RandomRays::hits(const Ray& ray, PrimitiveId id) const {
  RaySigns<ExactNumber> of_target = signs(ray, id);
  const std::optional<Sign> along = reaches(of_target, id);
  return along && of_target.pass(0) == *along && of_target.pass(1) == *along && of_target.pass(2) == *along;
}

bool RandomRays::in_window(const Vec3d& direction) const {
  if (!geometry_) return true;
  const Window& w = cell_.window->window;
  const auto side = [&](const auto& line) {
    return certain_sign(
               [&]<class N>() { return dot(line.template operator()<N>(), numbers<N>(direction)); }) *
           geometry_->handedness;
  };
  return side([&]<class N>() { return image_side<N>(*geometry_); }) == Sign::positive &&
         side([&]<class N>() { return x_border<N>(*geometry_, w.x0); }) != Sign::negative &&
         side([&]<class N>() { return x_border<N>(*geometry_, w.x1); }) != Sign::positive &&
         side([&]<class N>() { return y_border<N>(*geometry_, w.y0); }) != Sign::negative &&
         side([&]<class N>() { return y_border<N>(*geometry_, w.y1); }) != Sign::positive;
}

bool RandomRays::blocked(const Ray& ray, PrimitiveId target) const {
  return tree_.any([&](const Box& box) { return ray.may_meet(box); },
                   [&](PrimitiveId t) { return t != target && in_the_way(ray, t, target); });
}

bool RandomRays::in_the_way(const Ray& ray, PrimitiveId occluder, PrimitiveId target) const {
  if (scene_.triangle_flags()[occluder] & see_through) return false;
  RaySigns<ExactNumber> of_occluder = signs(ray, occluder);
  if (of_occluder.certainly_beside()) return false;
  const std::optional<Sign> along = reaches(of_occluder, occluder);
  if (!along) return false;
  for (int k = 0; k < 3; ++k)
    if (of_occluder.pass(k) == -*along) return false;
  // The distance to the target's plane less that to the occluder's, times both denominators squared.
  const auto hit = [&]<class N>(PrimitiveId t) {
    return ray_hit(numbers<N>(ray.start), numbers<N>(ray.towards), scene_.corner(t, 0), scene_.corner(t, 1),
                   scene_.corner(t, 2));
  };
  const Sign farther = certain_sign([&]<class N>() {
    const RayHit<N> o = hit.template operator()<N>(occluder), t = hit.template operator()<N>(target);
    return (t.reach * o.along - o.reach * t.along) * (o.along * t.along);
  });
  return farther != Sign::negative && !coplanar(occluder, target);
}

bool RandomRays::on_occluder(const Vec3d& p) const {
  return tree_.any(
      [&](const Box& box) {
        return meet(box, {p, p});
      },
      [&](PrimitiveId t) {
        return !(scene_.triangle_flags()[t] & see_through) &&
               on_triangle(p, scene_.corner(t, 0), scene_.corner(t, 1), scene_.corner(t, 2));
      });
}

bool RandomRays::coplanar(PrimitiveId first, PrimitiveId second) const {
  for (int k = 0; k < 3; ++k)
    if (plane_side(scene_.corner(first, 0), scene_.corner(first, 1), scene_.corner(first, 2),
                   scene_.corner(second, k)) != Sign::zero)
      return false;
  return true;
}

}  // namespace provis
