#include "tests/lod/solids.hpp"
#include "tests/support/triangles.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/formulas.hpp"

namespace provis::test {
namespace {

Vec3d lerp(const Vec3d& a, const Vec3d& b, double share) { return (1 - share) * a + share * b; }

Soup grid(const Vec3d& corner, const Vec3d& u, const Vec3d& v, int n) {
  Soup soup;
  const auto at = [&](int i, int j) { return corner + (double(i) / n) * u + (double(j) / n) * v; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      soup.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return soup;
}

template <class Cuts>
Soup box_of(const SolidBox& box, const Cuts& cuts) {
  const Vec3d lo = box.lower, hi = box.upper;
  const Vec3d x{hi.x - lo.x, 0, 0}, y{0, hi.y - lo.y, 0}, z{0, 0, hi.z - lo.z};
  Soup all;
  for (const auto& [corner, u, v] :
       {std::array{lo, z, y}, {lo + x, y, z}, {lo, x, z}, {lo + y, z, x}, {lo, y, x}, {lo + z, x, y}})
    all = joined(std::move(all), grid(corner, u, v, cuts()));
  return all;
}

}  // namespace

Soup box_solid(const SolidBox& box, int most, Random& random) {
  return box_of(box, [&] { return 1 << random.between(0, most); });
}

Soup box_solid(const SolidBox& box) {
  return box_of(box, [] { return 1; });
}

Soup octahedron(const Vec3d& c, double r) {
  Soup all;
  for (const double x : {-r, r})
    for (const double y : {-r, r})
      for (const double z : {-r, r}) {
        Corners t{c + Vec3d{x, 0, 0}, c + Vec3d{0, y, 0}, c + Vec3d{0, 0, z}};
        if (x * y * z < 0) std::swap(t[1], t[2]);
        all.push_back(t);
      }
  return all;
}

Soup ball(const Vec3d& center, double radius, int cuts) {
  Soup all = octahedron({0, 0, 0}, 1);
  for (; cuts > 0; --cuts) {
    Soup finer;
    for (const auto& [a, b, c] : all) {
      const Vec3d ab = lerp(a, b, 0.5), bc = lerp(b, c, 0.5), ca = lerp(c, a, 0.5);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    all = std::move(finer);
  }
  for (Corners& t : all)
    for (Vec3d& p : t) p = center + (radius / std::sqrt(dot(p, p))) * p;
  return all;
}

SolidBox around(const Soup& soup) {
  SolidBox box{soup[0][0], soup[0][0]};
  for (const Corners& t : soup)
    for (const Vec3d& p : t)
      for (int axis = 0; axis < 3; ++axis) {
        component(box.lower, axis) = std::min(component(box.lower, axis), component(p, axis));
        component(box.upper, axis) = std::max(component(box.upper, axis), component(p, axis));
      }
  return box;
}

Soup scaled(Soup soup, const Vec3d& center, double factor) {
  for (Corners& t : soup)
    for (Vec3d& p : t) p = center + factor * (p - center);
  return soup;
}

Soup reversed(Soup soup) {
  for (Corners& t : soup) std::swap(t[1], t[2]);
  return soup;
}

Soup joined(Soup a, const Soup& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

AddedIds add(SceneArrays& scene, const Soup& soup, std::uint8_t flags) {
  const AddedIds ids{static_cast<PrimitiveId>(scene.triangles.size()), static_cast<PrimitiveId>(soup.size())};
  for (const auto& [a, b, c] : soup) add_triangle(scene, a, b, c, flags);
  return ids;
}

}  // namespace provis::test
