#include "src/point/frame_point.hpp"

namespace provis {
namespace {

Vec3d values(const Vec3<Ball>& b) { return {b.x.value, b.y.value, b.z.value}; }

double radius(const Vec3<Ball>& b) { return std::max({b.x.radius, b.y.radius, b.z.radius}); }

}  // namespace

/// q = λ (f + x r + y u) has the products λ det with the rows below, times x, y and 1; for an eye at infinity
/// q = x r + y u + λ f has x det, y det and λ det.
FrameProjection::FrameProjection(const ViewGeometry& g) : eye_(g.eye), at_infinity_(g.at_infinity) {
  const Ball orientation(g.handedness == Sign::positive ? 1 : -1);
  const Vec3<Ball> r = numbers<Ball>(g.right), u = numbers<Ball>(g.up), f = numbers<Ball>(g.forward);
  const Vec3<Ball> x = orientation * cross(u, f), y = orientation * cross(f, r),
                   w = orientation * cross(r, u);
  determinant_ = dot(w, f);
  row_x_ = values(x);
  row_y_ = values(y);
  row_w_ = values(w);
  const double size = std::max({largest(row_x_), largest(row_y_), largest(row_w_)});
  const double inherited = std::max({radius(x), radius(y), radius(w)});
  // Three products of a row and a point that was moved to the eye, and two sums (ERRORS.md, 7).
  error_ = 3 * (8 * unit_roundoff * size + 2 * inherited);
  usable_ =
      determinant_.value - determinant_.radius > 0x1p-300 && determinant_.value < 0x1p300 && error_ < 0x1p300;
}

FramePoint FrameProjection::operator()(const Vec3d& p) const {
  const Vec3d q = p - eye_;
  const double error = error_ * largest(q) + 0x1p-900;
  const double x = dot(row_x_, q), y = dot(row_y_, q), along = dot(row_w_, q);
  if (at_infinity_)
    return {approximate(Vec3d{x, y, determinant_.value}, std::max(error, determinant_.radius)), along};
  return {approximate(Vec3d{x, y, along}, error), along};
}

}  // namespace provis
