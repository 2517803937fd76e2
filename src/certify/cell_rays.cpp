#include "src/certify/cell_rays.hpp"

#include "predicates/formulas.hpp"

namespace provis {
namespace {

using N = ExactNumber;

bool between(const N& x, double lo, double hi) {
  return sign_of(x - N(lo)) != Sign::negative && sign_of(N(hi) - x) != Sign::negative;
}

bool starts_in(const ViewCell& cell, const ExactRay& ray) {
  const Vec3<N>& o = ray.origin();
  return between(o.x, cell.lower.x, cell.upper.x) && between(o.y, cell.lower.y, cell.upper.y) &&
         between(o.z, cell.lower.z, cell.upper.z);
}

/// Whether the closed window, if there is one, holds the direction.
bool in_window(const ViewCell& cell, const ExactRay& ray) {
  if (!cell.window) return true;
  return passes_window(make_geometry(cell.lower, *cell.window, false), cell.window->window, ray.direction());
}

}  // namespace

bool belongs(const ExactRay& ray, const ViewCell& cell) {
  return starts_in(cell, ray) && in_window(cell, ray);
}

}  // namespace provis
