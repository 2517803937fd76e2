#include "src/lod/chain.hpp"

#include <algorithm>

#include "predicates/zero_area.hpp"
#include "provis/error.hpp"
#include "src/scene/certain_ray.hpp"
#include "src/scene/separation.hpp"

namespace provis::lod {
namespace {

/// How a ray crosses a triangle beyond its origin; unclear where it meets the border or runs along the plane.
enum class Crossing { none, outwards, inwards, unclear };

Crossing crossing(const CertainRay<Rational>& ray, const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  RaySigns<Rational> signs(ray, a, b, c);
  if (signs.certainly_beside()) return Crossing::none;
  const Sign along = signs.along();
  // Behind the origin, at it, or in a plane beside it.
  if (signs.reach() != along) return Crossing::none;
  bool border = false, inside = true;
  for (int k = 0; k < 3; ++k) {
    const Sign pass = signs.pass(k);
    border = border || pass == Sign::zero;
    inside = inside && pass * along != Sign::negative;
  }
  if (!inside) return Crossing::none;
  if (border) return Crossing::unclear;
  return along == Sign::positive ? Crossing::outwards : Crossing::inwards;
}

/// The k-th of a fixed sequence without order. Its numbers are short, so that exact products are.
Vec3d direction(std::uint64_t k) {
  std::uint64_t state = k;
  const auto next = [&] {
    constexpr std::uint64_t factor = 6364136223846793005u, summand = 1442695040888963407u;
    state = factor * state + summand;
    constexpr int bits = 20;
    return static_cast<double>(state >> (64 - bits)) - (1 << (bits - 1)) + 0.5;
  };
  const double x = next(), y = next();
  return {x, y, next()};
}

std::vector<PrimitiveId> with_area(const Scene& scene, std::vector<PrimitiveId> triangles) {
  std::erase_if(triangles, [&](PrimitiveId t) {
    return zero_area(scene.corner(t, 0), scene.corner(t, 1), scene.corner(t, 2));
  });
  return triangles;
}

}  // namespace

Chain::Chain(const Scene& scene, std::vector<PrimitiveId> triangles)
    : scene_(&scene), triangles_(with_area(scene, std::move(triangles))), tree_(scene, triangles_) {}

Winding Chain::winding(const Point& p) const {
  // All but a set of directions of measure zero will do.
  constexpr std::uint64_t most_tries = 10000;
  for (std::uint64_t k = 1; k <= most_tries; ++k) {
    Winding w{0, direction(k)};
    const CertainRay<Rational> ray{p, numbers<Rational>(w.direction), enclosed(p),
                                   numbers<Interval>(w.direction)};
    const bool unclear = tree_.any([&](const Box& box) { return ray.may_meet(box); },
                                   [&](std::uint32_t t) {
                                     const Crossing c = crossing(ray, scene_->corner(t, 0),
                                                                 scene_->corner(t, 1), scene_->corner(t, 2));
                                     if (c == Crossing::outwards) ++w.number;
                                     if (c == Crossing::inwards) --w.number;
                                     return c == Crossing::unclear;
                                   });
    if (!unclear) return w;
  }
  throw Error(Error::Code::internal, "winding number", "every ray meets an edge");
}

bool Chain::may_hold_part_of(const ViewCell& cell) const {
  const Box box{cell.lower, cell.upper};
  const auto may_meet = [&](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return meet(box, box_around(a, b, c)) && !TriangleAndBox({a, b, c}, box).separated(Gap::strict);
  };
  const bool met =
      tree_.any([&](const Box& b) { return meet(b, box); },
                [&](std::uint32_t t) {
                  return may_meet(scene_->corner(t, 0), scene_->corner(t, 1), scene_->corner(t, 2));
                });
  return met || winding(numbers<Rational>(cell.lower)).number != 0;
}

}  // namespace provis::lod
