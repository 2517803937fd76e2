#include "src/segment/exact_event.hpp"

#include <algorithm>
#include <sstream>

#include "predicates/exact_number.hpp"
#include "provis/error.hpp"

namespace provis {

ExactTime exact_root(const PathGeometry& path, const Pixel& at, const Motion& motion) {
  const Linear<ExactNumber> f = evaluate<ExactNumber>(path, at, motion);
  if (sign_of(f.slope) == Sign::zero)
    throw Error(Error::Code::internal, "segment", "an event without a root");
  return static_cast<ExactTime>(f.at_zero) / static_cast<ExactTime>(f.slope);
}

std::string text(const ExactTime& t) {
  std::ostringstream out;
  out << t.numerator() << '/' << t.denominator();
  return out.str();
}

int moments_before(const std::string& time, int count) {
  std::istringstream in(time);
  ExactTime t;
  if (!(in >> t)) throw Error(Error::Code::internal, "segment", "\"" + time + "\" is no time");
  // 2 k + 1 < 2 count t: k below the ceiling of count t - 1/2.
  const ExactTime twice = ExactTime(2 * count) * t - ExactTime(1);
  CGAL::Gmpz whole;
  mpz_cdiv_q(whole.mpz(), twice.numerator().mpz(), (CGAL::Gmpz(2) * twice.denominator()).mpz());
  return std::clamp(static_cast<int>(std::clamp(CGAL::to_double(whole), -1e9, 1e9)), 0, count);
}

}  // namespace provis
