#include "tests/support/pixel_ray.hpp"

namespace provis::test {

namespace {

/// A number whose denominator is a power of two.
Dyadic dyadic(Rational value) {
  value.canonicalize();
  return {value.get_num().get_str(), -static_cast<long>(mpz_sizeinbase(value.get_den_mpz_t(), 2) - 1)};
}

}  // namespace

std::optional<Vec3d> eye_at(const SegmentView& view, const Rational& t) {
  bool exact = true;
  const auto between = [&](double a, double b) {
    const Rational at = a + t * (Rational(b) - a);
    exact = exact && Rational(at.get_d()) == at;
    return at.get_d();
  };
  const Vec3d eye{between(view.from.x, view.to.x), between(view.from.y, view.to.y),
                  between(view.from.z, view.to.z)};
  return exact ? std::optional(eye) : std::nullopt;
}

Witness ray_along(const SegmentView& view, const Pixel& pixel, const Vec3d& eye) {
  const Frame& f = view.frames.at(static_cast<std::size_t>(pixel.frame));
  const Window& w = f.window;
  const Rational width = view.pixels.width, height = view.pixels.height;
  const Rational x = 2 * height * (2 * width * w.x0 + (2 * pixel.column + 1) * (Rational(w.x1) - w.x0));
  const Rational y = 2 * width * (2 * height * w.y1 - (2 * pixel.row + 1) * (Rational(w.y1) - w.y0));
  const Rational z = 4 * width * height;
  const auto sum = [&](double right, double up, double forward) {
    return dyadic(x * right + y * up + z * forward);
  };
  Witness ray;
  ray.origin = {dyadic(eye.x), dyadic(eye.y), dyadic(eye.z)};
  ray.direction = {sum(f.right.x, f.up.x, f.forward.x), sum(f.right.y, f.up.y, f.forward.y),
                   sum(f.right.z, f.up.z, f.forward.z)};
  return ray;
}

}  // namespace provis::test
