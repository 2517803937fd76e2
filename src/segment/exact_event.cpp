#include "src/segment/exact_event.hpp"

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

}  // namespace provis
