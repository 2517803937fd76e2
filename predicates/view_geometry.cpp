#include "predicates/view_geometry.hpp"

#include <cmath>

#include "predicates/exact_number.hpp"
#include "predicates/formulas.hpp"
#include "provis/error.hpp"

namespace provis {

ViewGeometry make_geometry(const Vec3d& eye, const Frame& frame, bool at_infinity) {
  ViewGeometry g{eye, frame.right, frame.up, frame.forward, at_infinity, Sign::positive, {0, 1, 2}, {}};
  g.handedness = sign_of(dot(numbers<ExactNumber>(frame.forward),
                             cross(numbers<ExactNumber>(frame.right), numbers<ExactNumber>(frame.up))));
  if (g.handedness == Sign::zero)
    throw Error(Error::Code::usage, "view", "right, up and forward are linearly dependent");
  if (!at_infinity) return g;

  int k = 0;
  for (int a = 1; a < 3; ++a)
    if (std::fabs(component(frame.forward, a)) > std::fabs(component(frame.forward, k))) k = a;
  g.axes = {(k + 1) % 3, (k + 2) % 3, k};
  g.shear_direction = frame.forward;
  if (component(frame.forward, k) < 0) {
    // Mirroring the direction mirrors the image; swapping both remaining axes mirrors it back.
    g.shear_direction = -frame.forward;
    g.axes = {(k + 2) % 3, (k + 1) % 3, k};
  }
  return g;
}

}  // namespace provis
