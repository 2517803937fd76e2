#include "tests/support/transform.hpp"

#include <gmpxx.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "tests/support/random.hpp"

namespace provis::test {

namespace {

Variant unchanged(const Case& c, const char* what) {
  Variant v{c, {}};
  v.changed.name += std::string(" | ") + what;
  for (PrimitiveId t = 0; t < c.arrays.triangles.size(); ++t) v.parts.push_back({t});
  return v;
}

void swap_windings(Case& c) {
  for (Triangle& t : c.arrays.triangles) std::swap(t[1], t[2]);
}

/// Applies one change to every position and one to every frame vector.
template <class Position, class Direction>
void for_each_vector(Case& c, const Position& position, const Direction& direction) {
  for (Vec3d& v : c.arrays.vertices) position(v);
  position(c.view.eye);
  for (Frame& f : c.view.frames) {
    for (Vec3d* v : {&f.right, &f.up, &f.forward}) direction(*v);
  }
}

/// value * 2^exponent, or nothing where that is no float64.
std::optional<double> shifted(double value, int exponent) {
  const double result = std::ldexp(value, exponent);
  if (!std::isfinite(result) || std::ldexp(result, -exponent) != value) return {};
  return result;
}

std::optional<double> exact_sum(double a, double b) {
  const double sum = a + b;
  if (!std::isfinite(sum) || mpq_class(a) + mpq_class(b) != mpq_class(sum)) return {};
  return sum;
}

/// The point halfway if it lies there exactly.
std::optional<Vec3d> exact_middle(const Vec3d& a, const Vec3d& b) {
  Vec3d middle;
  const std::pair<double*, std::array<double, 2>> coordinates[] = {
      {&middle.x, {a.x, b.x}}, {&middle.y, {a.y, b.y}}, {&middle.z, {a.z, b.z}}};
  for (const auto& [to, ends] : coordinates) {
    const std::optional<double> sum = exact_sum(ends[0], ends[1]);
    const std::optional<double> half = sum ? shifted(*sum, -1) : std::nullopt;
    if (!half) return {};
    *to = *half;
  }
  return middle;
}

bool has_area(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const auto exact = [](const Vec3d& v) { return Vec3<mpq_class>{v.x, v.y, v.z}; };
  const Vec3<mpq_class> n = cross(exact(b) - exact(a), exact(c) - exact(a));
  return n.x != 0 || n.y != 0 || n.z != 0;
}

}  // namespace

std::vector<bool> pull_back(const Variant& variant, const std::vector<bool>& visible_in_changed) {
  std::vector<bool> visible;
  for (const std::vector<PrimitiveId>& parts : variant.parts) {
    bool any = false;
    for (const PrimitiveId part : parts) any = any || visible_in_changed.at(part);
    visible.push_back(any);
  }
  return visible;
}

Variant permute_triangles(const Case& c, std::uint64_t seed) {
  Variant v = unchanged(c, "triangles permuted");
  Random random(seed);
  std::vector<PrimitiveId> order(c.arrays.triangles.size());
  std::iota(order.begin(), order.end(), PrimitiveId{0});
  random.shuffle(order);
  for (PrimitiveId to = 0; to < order.size(); ++to) {
    v.changed.arrays.triangles[to] = c.arrays.triangles[order[to]];
    v.changed.arrays.triangle_flags[to] = c.arrays.triangle_flags[order[to]];
    v.parts[order[to]] = {to};
  }
  return v;
}

Variant rotate_corners(const Case& c, std::uint64_t seed) {
  Variant v = unchanged(c, "corners rotated");
  Random random(seed);
  for (Triangle& t : v.changed.arrays.triangles) {
    const std::uint32_t by = random.below(3);
    t = {t[by], t[(by + 1) % 3], t[(by + 2) % 3]};
  }
  return v;
}

Variant split_vertices(const Case& c) {
  Variant v = unchanged(c, "vertices split");
  v.changed.arrays.vertices.clear();
  for (Triangle& t : v.changed.arrays.triangles) {
    for (std::uint32_t& corner : t) {
      v.changed.arrays.vertices.push_back(c.arrays.vertices[corner]);
      corner = static_cast<std::uint32_t>(v.changed.arrays.vertices.size() - 1);
    }
  }
  return v;
}

std::optional<Variant> scale(const Case& c, int exponent) {
  Variant v = unchanged(c, "scaled");
  bool exact = true;
  const auto scale_vector = [&](Vec3d& p) {
    for (double* value : {&p.x, &p.y, &p.z}) {
      const std::optional<double> scaled = shifted(*value, exponent);
      exact = exact && scaled;
      *value = scaled.value_or(*value);
    }
  };
  const bool parallel = c.view.projection == Projection::parallel;
  for_each_vector(v.changed, scale_vector, [&](Vec3d& d) {
    if (parallel) scale_vector(d);
  });
  if (!exact) return {};
  return v;
}

std::optional<Variant> translate(const Case& c, const Vec3d& by) {
  Variant v = unchanged(c, "translated");
  bool exact = true;
  const auto move = [&](double& value, double step) {
    const std::optional<double> sum = exact_sum(value, step);
    exact = exact && sum;
    value = sum.value_or(value);
  };
  const auto move_vector = [&](Vec3d& p) {
    move(p.x, by.x);
    move(p.y, by.y);
    move(p.z, by.z);
  };
  for_each_vector(v.changed, move_vector, [](Vec3d&) {});
  if (!exact) return {};
  return v;
}

Variant permute_axes(const Case& c, const std::array<int, 3>& axes) {
  Variant v = unchanged(c, "axes permuted");
  const auto permute = [&](Vec3d& p) {
    const double old[3] = {p.x, p.y, p.z};
    p = {old[axes[0]], old[axes[1]], old[axes[2]]};
  };
  for_each_vector(v.changed, permute, permute);
  const bool even = (axes[0] + 1) % 3 == axes[1];
  if (!even) swap_windings(v.changed);
  return v;
}

Variant mirror(const Case& c, int axis) {
  Variant v = unchanged(c, "mirrored");
  const auto negate = [&](Vec3d& p) {
    double& value = axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    value = -value;
  };
  for_each_vector(v.changed, negate, negate);
  swap_windings(v.changed);
  return v;
}

Variant add_triangle(const Case& c, std::uint64_t seed) {
  Variant v = unchanged(c, "triangle added");
  Random random(seed);
  SceneArrays& arrays = v.changed.arrays;
  Triangle corners{};
  for (std::uint32_t& corner : corners) {
    const Vec3d& p = random.pick_from(c.arrays.vertices);
    const Vec3d& q = random.chance(50) ? p : random.pick_from(c.arrays.vertices);
    corner = static_cast<std::uint32_t>(arrays.vertices.size());
    arrays.vertices.push_back({(p.x + q.x) / 2, (p.y + q.y) / 2, (p.z + q.z) / 2});
  }
  arrays.triangles.push_back(corners);
  arrays.triangle_flags.push_back(0);
  return v;
}

std::optional<Variant> cut_triangles(const Case& c, std::uint64_t seed) {
  Variant v = unchanged(c, "triangles cut");
  Random random(seed);
  SceneArrays& arrays = v.changed.arrays;
  bool cut_any = false;
  for (PrimitiveId t = 0; t < c.arrays.triangles.size(); ++t) {
    const std::uint32_t k = random.below(3);
    const Triangle old = c.arrays.triangles[t];
    const std::uint32_t a = old[k], b = old[(k + 1) % 3], apex = old[(k + 2) % 3];
    const std::vector<Vec3d>& at = c.arrays.vertices;
    const std::optional<Vec3d> middle = exact_middle(at[a], at[b]);
    if (!middle || !has_area(at[a], *middle, at[apex]) || random.chance(30)) continue;
    const auto m = static_cast<std::uint32_t>(arrays.vertices.size());
    arrays.vertices.push_back(*middle);
    arrays.triangles[t] = {a, m, apex};
    v.parts[t].push_back(static_cast<PrimitiveId>(arrays.triangles.size()));
    arrays.triangles.push_back({m, b, apex});
    arrays.triangle_flags.push_back(c.arrays.triangle_flags[t]);
    cut_any = true;
  }
  if (!cut_any) return {};
  return v;
}

}  // namespace provis::test
