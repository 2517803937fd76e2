#include "src/point/dyadic.hpp"

#include <sstream>

namespace provis {

Dyadic dyadic(const Rational& x) {
  std::ostringstream mantissa;
  mantissa << x.numerator();
  return {mantissa.str(), -static_cast<long>(mpz_sizeinbase(x.denominator().mpz(), 2) - 1)};
}

}  // namespace provis
