#include "predicates/environment.hpp"

#include <limits>

#include "provis/error.hpp"

namespace provis {
namespace {

// The operands pass through volatile so that no compiler can fold the question away.
double product_difference(double a, double b, double c, double d) {
  volatile double va = a, vb = b, vc = c, vd = d;
  const double x = va, y = vb, z = vc, w = vd;
  return x * y - z * w;
}

double sum(double a, double b) {
  volatile double va = a, vb = b;
  return va + vb;
}

void refuse(const char* what) { throw Error(Error::Code::internal, "floating-point environment", what); }

}  // namespace

bool rounds_up() { return sum(1.0, std::numeric_limits<double>::denorm_min()) > 1.0; }

void check_environment() {
  const double third = 1.0 / 3.0;
  const RoundNearest nearest;
  // Contracted to a fused operation this is the rounding error of the product, not zero.
  if (product_difference(third, third, third, third) != 0)
    refuse("products and sums are contracted to fused operations");
  if (sum(1.0, std::numeric_limits<double>::epsilon() / 4) != 1.0) refuse("sums are not rounded to nearest");
  {
    const RoundUp up;
    if (!rounds_up()) refuse("the rounding mode is not obeyed");
  }
  volatile double smallest = std::numeric_limits<double>::min();
  if (smallest / 2 == 0 || smallest / 2 * 2 != smallest) refuse("subnormal numbers are flushed to zero");
}

}  // namespace provis
