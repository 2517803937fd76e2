#include "src/region/random_rays.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/certain_sign.hpp"
#include "predicates/environment.hpp"
#include "predicates/formulas.hpp"
#include "predicates/on_triangle.hpp"
#include "predicates/ray_hit.hpp"
#include "predicates/view_geometry.hpp"
#include "src/region/dyadic_point.hpp"
#include "src/scene/random.hpp"
#include "src/scene/ray_box.hpp"

namespace provis {

/// Two float64 points taken as exact; bounds are made once.
struct RandomRays::Ray {
  Vec3d origin, direction;

  template <class N>
  RayHit<N> hit(const Scene& scene, PrimitiveId t) const {
    return ray_hit(numbers<N>(origin), numbers<N>(direction), scene.corner(t, 0), scene.corner(t, 1),
                   scene.corner(t, 2));
  }
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

bool shows(const Scene& scene, PrimitiveId t, Sign along) {
  return !(scene.triangle_flags()[t] & single_sided) || along == Sign::negative;
}

}  // namespace

std::optional<Witness> RandomRays::aim_at(PrimitiveId id, int rays, std::uint64_t seed) const {
  Random random(seed * 0x100000001b3u + id);
  const Vec3d &lo = cell_.lower, &hi = cell_.upper;
  for (int k = 0; k < rays; ++k) {
    Ray ray;
    {
      const RoundNearest guard;
      ray.origin = {any_between(lo.x, hi.x, random), any_between(lo.y, hi.y, random),
                    any_between(lo.z, hi.z, random)};
      ray.direction =
          any_point(scene_.corner(id, 0), scene_.corner(id, 1), scene_.corner(id, 2), random) - ray.origin;
    }
    const RoundUp guard;
    if (!hits(ray, id) || !in_window(ray.direction) || blocked(ray, id) || on_occluder(ray.origin)) continue;
    return Witness{id, dyadic(ray.origin), dyadic(ray.direction)};
  }
  return std::nullopt;
}

bool RandomRays::hits(const Ray& ray, PrimitiveId id) const {
  const auto sign = [&](const auto& part) {
    return certain_sign([&]<class N>() { return part(ray.hit<N>(scene_, id)); });
  };
  const Sign along = sign([](const auto& h) { return h.along; });
  if (along == Sign::zero || !shows(scene_, id, along)) return false;
  if (sign([](const auto& h) { return h.reach; }) != along) return false;
  for (int k = 0; k < 3; ++k)
    if (sign([&](const auto& h) { return h.passes[k]; }) != along) return false;
  return true;
}

bool RandomRays::in_window(const Vec3d& direction) const {
  if (!cell_.window) return true;
  const ViewGeometry g = make_geometry(cell_.lower, *cell_.window, false);
  const Window& w = cell_.window->window;
  const auto side = [&](const auto& line) {
    return certain_sign(
               [&]<class N>() { return dot(line.template operator()<N>(), numbers<N>(direction)); }) *
           g.handedness;
  };
  return side([&]<class N>() { return image_side<N>(g); }) == Sign::positive &&
         side([&]<class N>() { return x_border<N>(g, w.x0); }) != Sign::negative &&
         side([&]<class N>() { return x_border<N>(g, w.x1); }) != Sign::positive &&
         side([&]<class N>() { return y_border<N>(g, w.y0); }) != Sign::negative &&
         side([&]<class N>() { return y_border<N>(g, w.y1); }) != Sign::positive;
}

bool RandomRays::blocked(const Ray& ray, PrimitiveId target) const {
  const auto origin = numbers<Interval>(ray.origin), direction = numbers<Interval>(ray.direction);
  return tree_.any([&](const Box& box) { return ray_may_meet(origin, direction, box); },
                   [&](PrimitiveId t) { return t != target && in_the_way(ray, t, target); });
}

/// A plane that holds the origin has reach zero and no hits (R6).
bool RandomRays::in_the_way(const Ray& ray, PrimitiveId occluder, PrimitiveId target) const {
  if (scene_.triangle_flags()[occluder] & see_through) return false;
  const auto sign = [&](const auto& part) {
    return certain_sign([&]<class N>() { return part(ray.hit<N>(scene_, occluder)); });
  };
  const Sign along = sign([](const auto& h) { return h.along; });
  if (along == Sign::zero || !shows(scene_, occluder, along)) return false;
  if (sign([](const auto& h) { return h.reach; }) != along) return false;
  for (int k = 0; k < 3; ++k)
    if (sign([&](const auto& h) { return h.passes[k]; }) == -along) return false;
  // The distance to the target's plane less that to the occluder's, times both denominators squared.
  const Sign farther = certain_sign([&]<class N>() {
    const RayHit<N> o = ray.hit<N>(scene_, occluder), t = ray.hit<N>(scene_, target);
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
  const Vec3d &a = scene_.corner(first, 0), &b = scene_.corner(first, 1), &c = scene_.corner(first, 2);
  for (int k = 0; k < 3; ++k) {
    const Sign height = certain_sign([&]<class N>() {
      const Vec3<N> o = numbers<N>(a);
      return dot(cross(numbers<N>(b) - o, numbers<N>(c) - o), numbers<N>(scene_.corner(second, k)) - o);
    });
    if (height != Sign::zero) return false;
  }
  return true;
}

}  // namespace provis
