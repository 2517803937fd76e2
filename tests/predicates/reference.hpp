#pragma once
// The signs again, over rationals and by another road: in window coordinates by Cramer's rule, not by
// functionals on world coordinates. Shares no formula with predicates/.

#include <CGAL/Gmpq.h>

#include <array>

#include "predicates/line.hpp"
#include "predicates/view_geometry.hpp"

namespace provis::test {

using Rational = CGAL::Gmpq;
using RationalVector = std::array<Rational, 3>;

RationalVector rational(const Vec3d& v);
RationalVector operator-(const RationalVector& a, const RationalVector& b);
RationalVector cross_product(const RationalVector& a, const RationalVector& b);
Rational dot_product(const RationalVector& a, const RationalVector& b);
Rational determinant(const RationalVector& a, const RationalVector& b, const RationalVector& c);
Sign rational_sign(const Rational& q);
bool is_zero(const RationalVector& v);

/// Window coordinates: a ray is (w, wX, wY), w > 0 in the image; finite eyes allow any w.
class Reference {
 public:
  explicit Reference(const ViewGeometry& geometry);

  Sign side(const Line& line, const Direction& direction) const;
  Sign facing(const Vec3d& a, const Vec3d& b, const Vec3d& c) const;
  Sign front(const Vec3d& p) const;
  static bool coplanar(const Corners& a, const Corners& b);

 private:
  /// Homogeneous window coordinates, times |det(forward, right, up)|, and how far along forward it lies.
  struct Image {
    RationalVector ray;
    Rational depth;
  };
  Image image(const Vec3d& p) const;
  RationalVector window_ray(const RationalVector& world) const;
  RationalVector unsheared(const RationalVector& sheared) const;
  RationalVector ray(const Direction& direction) const;
  RationalVector functional(const Line& line) const;
  RationalVector depth_functional(const Corners& corners) const;

  const ViewGeometry& g_;
  RationalVector eye_, right_, up_, forward_;
  Rational det_, hand_;  ///< of (forward, right, up), and its sign
};

}  // namespace provis::test
