#include "tests/predicates/near_degenerate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <limits>

#include "predicates/environment.hpp"
#include "provis/error.hpp"

namespace provis::test {
namespace {

/// A draft of an input, before its frame is known to be independent.
struct Draft {
  Vec3d eye;
  Frame frame;
  std::array<Vec3d, 7> points;
  bool at_infinity = false;
};

template <class F>
void for_each_vector(Draft& d, const F& f) {
  f(d.eye);
  f(d.frame.right);
  f(d.frame.up);
  f(d.frame.forward);
  for (Vec3d& p : d.points) f(p);
}

template <class F>
void for_each_number(Vec3d& v, const F& f) {
  f(v.x);
  f(v.y);
  f(v.z);
}

double uniform(Random& r) { return 2 * r.unit() - 1; }

Vec3d uniform_vector(Random& r) {
  const double x = uniform(r), y = uniform(r), z = uniform(r);
  return {x, y, z};
}

/// A factor that is exact more often than not.
double factor(Random& r) {
  switch (r.below(4)) {
    case 0:
      return r.pick({0.5, 2.0, 3.0, -1.0, -0.25});
    case 1:
      return double(r.between(-8, 8)) / 8;
    case 2:
      return 1 + double(r.between(-3, 3)) * std::numeric_limits<double>::epsilon();
    default:
      return uniform(r);
  }
}

void fill_generic(Draft& d, Random& r) {
  for_each_vector(d, [&](Vec3d& v) { v = uniform_vector(r); });
}

void fill_grid(Draft& d, Random& r) {
  const int size = r.between(1, 4);
  for_each_vector(d, [&](Vec3d& v) { v = r.lattice(size); });
}

void fill_coincident(Draft& d, Random& r) {
  r.chance(50) ? fill_grid(d, r) : fill_generic(d, r);
  for (Vec3d& p : d.points) p = r.chance(10) ? d.eye : d.points[r.below(3)];
}

void fill_same_ray(Draft& d, Random& r) {
  r.chance(50) ? fill_grid(d, r) : fill_generic(d, r);
  for (std::size_t k = 2; k < d.points.size(); ++k) {
    const Vec3d& from = d.points[r.below(k)];
    d.points[k] = d.at_infinity ? from + factor(r) * d.frame.forward : d.eye + factor(r) * (from - d.eye);
  }
}

void fill_flat(Draft& d, Random& r, bool line) {
  r.chance(50) ? fill_grid(d, r) : fill_generic(d, r);
  const Vec3d &a = d.points[0], u = d.points[1] - a, v = d.points[2] - a;
  for (std::size_t k = line ? 2 : 3; k < d.points.size(); ++k)
    d.points[k] = line ? a + factor(r) * u : a + factor(r) * u + factor(r) * v;
  if (r.chance(20)) d.eye = a + factor(r) * u;
}

void fill_proportional(Draft& d, Random& r) {
  r.chance(50) ? fill_grid(d, r) : fill_generic(d, r);
  for (std::size_t k = 1; k < d.points.size(); ++k) {
    Vec3d v = factor(r) * d.points[0];
    for_each_number(v, [&](double& x) { x = nudged(x, r); });
    if (r.chance(70)) d.points[k] = v;
  }
  d.frame.up = d.frame.right;
  for_each_number(d.frame.up, [&](double& x) { x = r.chance(50) ? x + 0x1p-20 * uniform(r) : nudged(x, r); });
  if (r.chance(50)) d.eye = {0, 0, 0};
}

void nudge_all(Draft& d, Random& r) {
  for_each_vector(
      d, [&](Vec3d& v) { for_each_number(v, [&](double& x) { x = r.chance(30) ? nudged(x, r) : x; }); });
}

void move_away(Draft& d, Random& r) {
  r.chance(50) ? fill_grid(d, r) : fill_generic(d, r);
  const Vec3d offset = std::ldexp(1.0, r.between(10, 50)) * uniform_vector(r);
  d.eye = d.eye + offset;
  for (Vec3d& p : d.points) p = p + offset;
}

void scale_points(Draft& d, Random& r) {
  const int k = r.between(-990, 990), frame = r.chance(50) ? k : r.between(-3, 3);
  for_each_number(d.eye, [&](double& x) { x = std::ldexp(x, k); });
  for (Vec3d& p : d.points) for_each_number(p, [&](double& x) { x = std::ldexp(x, k); });
  for (Vec3d* v : {&d.frame.right, &d.frame.up, &d.frame.forward})
    for_each_number(*v, [&](double& x) { x = std::ldexp(x, frame); });
}

void fill(Draft& d, NearFamily family, Random& r) {
  switch (family) {
    case NearFamily::generic:
      return fill_generic(d, r);
    case NearFamily::grid:
      return fill_grid(d, r);
    case NearFamily::coincident:
      return fill_coincident(d, r);
    case NearFamily::same_ray:
      return fill_same_ray(d, r);
    case NearFamily::coplanar:
      return fill_flat(d, r, false);
    case NearFamily::collinear:
      return fill_flat(d, r, true);
    case NearFamily::proportional:
      return fill_proportional(d, r);
    case NearFamily::nudged:
      fill_grid(d, r);
      return nudge_all(d, r);
    case NearFamily::far_away:
      return move_away(d, r);
    case NearFamily::scaled:
      fill(d, r.pick({NearFamily::generic, NearFamily::grid, NearFamily::coplanar, NearFamily::nudged}), r);
      return scale_points(d, r);
    case NearFamily::mixed:
      return for_each_vector(d, [&](Vec3d& v) {
        for_each_number(v, [&](double& x) { x = std::ldexp(uniform(r), r.between(-60, 60)); });
      });
    case NearFamily::subnormal:
      fill_grid(d, r);
      for_each_number(d.eye, [&](double& x) { x = std::ldexp(x, -1074); });
      for (Vec3d& p : d.points) for_each_number(p, [&](double& x) { x = std::ldexp(x, -1074); });
      return;
    case NearFamily::extreme:
      return for_each_vector(d, [&](Vec3d& v) { for_each_number(v, [&](double& x) { x = any_number(r); }); });
  }
}

}  // namespace

std::string_view name(NearFamily family) {
  constexpr std::string_view names[] = {"generic",   "grid",         "coincident", "same_ray", "coplanar",
                                        "collinear", "proportional", "nudged",     "far_away", "scaled",
                                        "mixed",     "subnormal",    "extreme"};
  return names[static_cast<std::size_t>(family)];
}

Input make_input(NearFamily family, std::uint64_t seed) {
  const RoundNearest guard;
  Random r(seed * std::size(families) + static_cast<std::uint64_t>(family));
  for (;;) {
    Draft d;
    d.at_infinity = r.chance(50);
    fill(d, family, r);
    try {
      Input in{make_geometry(d.eye, d.frame, d.at_infinity), d.points, {}, {}};
      for (double& x : in.at) x = r.chance(50) ? double(r.between(-4, 4)) / 4 : uniform(r);
      if (family == NearFamily::extreme) in.at[0] = any_number(r);
      do in.given = r.chance(50) ? r.lattice(2) : d.points[0] - d.eye;
      while (!(std::fabs(in.given.x) + std::fabs(in.given.y) + std::fabs(in.given.z) > 0) ||
             !(std::fabs(in.given.x) < HUGE_VAL && std::fabs(in.given.y) < HUGE_VAL &&
               std::fabs(in.given.z) < HUGE_VAL));
      return in;
    } catch (const Error&) {
      // A frame of dependent vectors is no view: draw again.
    }
  }
}

double nudged(double x, Random& r) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const int way = r.between(-1, 1);
  return way == 0 ? x : std::nextafter(x, way > 0 ? infinity : -infinity);
}

double any_number(Random& r) {
  const RoundNearest guard;
  const double sign = r.chance(50) ? 1 : -1;
  switch (r.below(6)) {
    case 0:
      return double(r.between(-8, 8));
    case 1:
      return sign * r.unit();
    case 2:
      return sign * double(r.below(1u << 30)) * std::numeric_limits<double>::denorm_min();
    case 3:
      return sign * std::ldexp(1 + r.unit() / 2, 1023);
    case 4:
      return sign * std::ldexp(1 + double(r.between(-2, 2)) * 0x1p-52, r.between(-1074, 1023));
    default:
      return sign * std::ldexp(r.unit(), r.between(-1074, 1023));
  }
}

}  // namespace provis::test
