#include "src/point/witness_point.hpp"

#include <algorithm>

#include "provis/error.hpp"
#include "src/point/area.hpp"
#include "src/point/dyadic.hpp"

namespace provis {
namespace {

/// floor(q * 2^bits) / 2^bits
ExactNumber rounded_down(const Rational& q, int bits) {
  CGAL::Gmpz n;
  mpz_mul_2exp(n.mpz(), q.numerator().mpz(), static_cast<mp_bitcnt_t>(bits));
  mpz_fdiv_q(n.mpz(), n.mpz(), q.denominator().mpz());
  if (n == 0) return ExactNumber(0.0);
  // Mpzf's constructor from an integer takes the magnitude and forgets the sign (CGAL 5.5.1).
  ExactNumber scaled(CGAL::abs(n));
  if (n < 0) scaled = -scaled;
  constexpr int step = 512;
  for (int left = bits; left > 0; left -= step)
    scaled = scaled * ExactNumber(std::ldexp(1.0, -std::min(left, step)));
  return scaled;
}

bool strictly_inside(const ViewGeometry& g, const Cell& cell, const WitnessPoint& p) {
  const Vec3<ExactNumber> ray = exact_ray(g, p);
  return std::all_of(cell.lines.begin(), cell.lines.end(),
                     [&](const Side& l) { return exact_side(g, l, ray) == Sign::positive; });
}

}  // namespace

Vec3<ExactNumber> exact_ray(const ViewGeometry& g, const WitnessPoint& p) {
  using N = ExactNumber;
  return frame_center<N>(g) + p.x * project_vector<N>(g, g.right) + p.y * project_vector<N>(g, g.up);
}

Sign exact_side(const ViewGeometry& g, const Side& side, const Vec3<ExactNumber>& ray) {
  const Sign s = sign_of(dot(evaluate<ExactNumber>(g, *side.line), ray));
  return side.negated ? -s : s;
}

WitnessPoint interior_point(const ViewGeometry& g, const Cell& cell, std::size_t attempt) {
  const std::vector<WindowPoint> polygon = window_polygon(g, cell);
  // Corner k weighs (1 + attempt)^k. A line holds a mean iff a polynomial of the attempt vanishes, one that
  // has a coefficient for each corner: it is not zero, for no line holds all corners.
  const Rational base = static_cast<double>(1 + attempt);
  Rational x = 0, y = 0, n = 0, weight = 1;
  for (const WindowPoint& p : polygon) {
    const Rational w = static_cast<Rational>(p.w);
    x += weight * static_cast<Rational>(p.x) / w;
    y += weight * static_cast<Rational>(p.y) / w;
    n += weight;
    weight *= base;
  }
  // A weighted mean of the corners lies strictly inside, so some precision keeps it there; the limit is far
  // beyond what the coordinates of any cell can need, and only broken signs reach it.
  constexpr int most_bits = 1 << 20;
  for (int bits = 32; bits <= most_bits; bits *= 2) {
    const WitnessPoint p{rounded_down(x / n, bits), rounded_down(y / n, bits)};
    if (strictly_inside(g, cell, p)) return p;
  }
  throw Error(Error::Code::internal, "witness", "a cell without an interior point");
}

Witness make_witness(PrimitiveId primitive, const ViewGeometry& g, const WitnessPoint& p) {
  using N = ExactNumber;
  const Vec3<N> offset = p.x * numbers<N>(g.right) + p.y * numbers<N>(g.up);
  const Vec3<N> eye = numbers<N>(g.eye), forward = numbers<N>(g.forward);
  if (g.at_infinity) return {primitive, dyadic(eye + offset), dyadic(forward)};
  return {primitive, dyadic(eye), dyadic(forward + offset)};
}

}  // namespace provis
