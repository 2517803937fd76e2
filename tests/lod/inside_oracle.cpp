#include "tests/lod/inside_oracle.hpp"

#include <optional>

namespace provis::test {

Exact3 exact_point(const Vec3d& p) { return {p.x, p.y, p.z}; }

Exact3 InsideOracle::corner(std::size_t t, std::size_t k) const {
  return exact_point(chain_.vertices[chain_.triangles[t][k]]);
}

Exact3 InsideOracle::normal(std::size_t t) const {
  return cross(Exact3(corner(t, 1) - corner(t, 0)), Exact3(corner(t, 2) - corner(t, 0)));
}

/// Where a point of the triangle's plane lies.
InsideOracle::Place InsideOracle::place(const Exact3& p, std::size_t t) const {
  const Exact3 n = normal(t);
  Place result = Place::inside;
  for (std::size_t k = 0; k < 3; ++k) {
    const Exact3 a = corner(t, k), b = corner(t, (k + 1) % 3);
    const int s = sgn(dot(cross(Exact3(b - a), Exact3(p - a)), n));
    if (s < 0) return Place::off;
    if (s == 0) result = Place::border;
  }
  return result;
}

int InsideOracle::winding(const Exact3& p, const Exact3& towards) {
  for (;;) {
    const Exact3 d{random_.between(-4000, 4000), random_.between(-4000, 4000), random_.between(-4000, 4000)};
    if (dot(d, towards) <= 0) continue;
    int sum = 0;
    bool doubt = false;
    for (std::size_t t = 0; t < chain_.triangles.size() && !doubt; ++t) {
      const Exact3 n = normal(t);
      if (dot(n, n) == 0) continue;
      const mpq_class along = dot(n, d), reach = dot(n, Exact3(corner(t, 0) - p));
      if (along == 0) {
        doubt = reach == 0;
        continue;
      }
      const mpq_class distance = reach / along;
      if (distance <= 0) continue;
      const Place where = place(p + distance * d, t);
      doubt = where == Place::border;
      if (where == Place::inside) sum += sgn(along);
    }
    if (!doubt) return sum;
  }
}

bool InsideOracle::by_any_side(const Exact3& p) {
  for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
    const Exact3 n = normal(t);
    if (dot(n, n) != 0 && dot(n, Exact3(p - corner(t, 0))) == 0 && place(p, t) != Place::off) return true;
  }
  return winding(p, exact_point(random_.chance(50) ? Vec3d{1, 2, 3} : Vec3d{-3, 1, -2})) != 0;
}

bool InsideOracle::by_fronts(const Exact3& p, const Exact3& n) {
  bool over = false, under = false;
  for (std::size_t t = 0; t < chain_.triangles.size(); ++t) {
    const Exact3 m = normal(t);
    if (dot(m, m) == 0 || dot(m, Exact3(p - corner(t, 0))) != 0) continue;
    const Place where = place(p, t);
    if (where == Place::off) continue;
    const Exact3 across = cross(n, m);
    if (where == Place::border || dot(across, across) != 0) return true;
    const bool both = !(chain_.triangle_flags[t] & single_sided);
    over = over || both || dot(n, m) > 0;
    under = under || both || dot(n, m) < 0;
  }
  const Exact3 down = mpq_class(-1) * n;
  return (over || winding(p, n) > 0) && (under || winding(p, down) > 0);
}

}  // namespace provis::test
