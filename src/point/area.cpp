#include "src/point/area.hpp"

#include <cmath>

namespace provis {

WindowPoint window_point(const ViewGeometry& g, const Direction& ray) {
  using N = ExactNumber;
  const Vec3<N> q = evaluate<N>(g, ray);
  const Vec3<N> c = frame_center<N>(g), r = project_vector<N>(g, g.right), u = project_vector<N>(g, g.up);
  return {dot(q, cross(u, c)), dot(q, cross(c, r)), dot(q, cross(r, u))};
}

Vec3d rounded(const WindowPoint& p) {
  const double x = CGAL::to_double(p.x), y = CGAL::to_double(p.y), w = CGAL::to_double(p.w);
  constexpr double smallest = 0x1p-900, largest = 0x1p900;
  const bool safe =
      std::fabs(w) > smallest && std::fabs(w) < largest && std::fabs(x) < largest && std::fabs(y) < largest;
  if (safe) return {x / w, y / w, 0};
  const Rational divisor = static_cast<Rational>(p.w);
  return {CGAL::to_double(static_cast<Rational>(p.x) / divisor),
          CGAL::to_double(static_cast<Rational>(p.y) / divisor), 0};
}

std::vector<WindowPoint> window_polygon(const ViewGeometry& g, const Cell& cell) {
  std::vector<WindowPoint> polygon;
  for (const Direction& v : cell.vertices) polygon.push_back(window_point(g, v));
  return polygon;
}

Rational area(const std::vector<WindowPoint>& p) {
  // Twice the area is the sum of (x_k y_k+1 - x_k+1 y_k)/(w_k w_k+1), here over the product of all w.
  ExactNumber sum = 0.0, product = 1.0;
  for (const WindowPoint& point : p) product = product * point.w;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const WindowPoint &a = p[k], &b = p[(k + 1) % p.size()];
    ExactNumber term = a.x * b.y - b.x * a.y;
    for (std::size_t j = 0; j < p.size(); ++j)
      if (j != k && j != (k + 1) % p.size()) term = term * p[j].w;
    sum = sum + term;
  }
  const Rational doubled = static_cast<Rational>(sum) / static_cast<Rational>(product);
  return (doubled < 0 ? -doubled : doubled) / 2;
}

std::uint64_t AreaBalance::residue(const Rational& q) {
  CGAL::Gmpz modulus, inverse;
  mpz_set_ui(modulus.mpz(), prime);
  // A denominator divisible by the prime has no residue; leaving it out as zero fails the balance loudly.
  if (mpz_invert(inverse.mpz(), q.denominator().mpz(), modulus.mpz()) == 0) return 0;
  mpz_mul(inverse.mpz(), inverse.mpz(), q.numerator().mpz());
  return mpz_fdiv_ui(inverse.mpz(), prime);
}

}  // namespace provis
