#include "src/lod/chain.hpp"

#include <algorithm>
#include <optional>

#include "predicates/ray_hit.hpp"
#include "predicates/zero_area.hpp"
#include "provis/error.hpp"
#include "src/lod/box_contact.hpp"
#include "src/scene/ray_box.hpp"

namespace provis::lod {
namespace {

/// How a ray crosses a triangle beyond its origin; unclear where it meets the border or runs along the plane.
enum class Crossing { none, outwards, inwards, unclear };

/// A ray of a rational origin and a float64 direction.
class Ray {
 public:
  Ray(const Point& origin, const Vec3d& direction)
      : origin_(origin),
        direction_(numbers<Rational>(direction)),
        origin_bounds_(enclosed(origin)),
        direction_bounds_(numbers<Interval>(direction)) {}

  bool may_meet(const Box& box) const { return ray_may_meet(origin_bounds_, direction_bounds_, box); }

  Crossing crosses(const Vec3d& a, const Vec3d& b, const Vec3d& c) const {
    const RayHit<Interval> i = ray_hit(origin_bounds_, direction_bounds_, a, b, c);
    const auto some = [&](auto certainly) {
      return certainly(i.passes[0]) || certainly(i.passes[1]) || certainly(i.passes[2]);
    };
    if (some([](const Interval& x) { return x.inf() > 0; }) &&
        some([](const Interval& x) { return x.sup() < 0; }))
      return Crossing::none;
    std::optional<RayHit<Rational>> exact;
    const auto sign = [&](const Interval& x, auto part) {
      if (const auto s = provis::sign_of(x)) return *s;
      if (!exact) exact = ray_hit(origin_, direction_, a, b, c);
      return sign_of(part(*exact));
    };
    const Sign along = sign(i.along, [](const RayHit<Rational>& h) { return h.along; });
    // Behind the origin, at it, or in a plane beside it.
    if (sign(i.reach, [](const RayHit<Rational>& h) { return h.reach; }) != along) return Crossing::none;
    bool border = false, inside = true;
    for (int k = 0; k < 3; ++k) {
      const Sign pass = sign(i.passes[k], [k](const RayHit<Rational>& h) { return h.passes[k]; });
      border = border || pass == Sign::zero;
      inside = inside && pass * along != Sign::negative;
    }
    if (!inside) return Crossing::none;
    if (border) return Crossing::unclear;
    return along == Sign::positive ? Crossing::outwards : Crossing::inwards;
  }

 private:
  Point origin_, direction_;
  Vec3<Interval> origin_bounds_, direction_bounds_;
};

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
    const Ray ray(p, w.direction);
    const bool unclear = tree_.any([&](const Box& box) { return ray.may_meet(box); },
                                   [&](std::uint32_t t) {
                                     const Crossing c = ray.crosses(
                                         scene_->corner(t, 0), scene_->corner(t, 1), scene_->corner(t, 2));
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
  const bool met =
      tree_.any([&](const Box& b) { return meet(b, box); },
                [&](std::uint32_t t) {
                  return may_meet(box, scene_->corner(t, 0), scene_->corner(t, 1), scene_->corner(t, 2));
                });
  return met || winding(numbers<Rational>(cell.lower)).number != 0;
}

}  // namespace provis::lod
