#include "provis/arithmetic.hpp"

namespace provis {

std::string_view name(Arithmetic arithmetic) {
  switch (arithmetic) {
    case Arithmetic::doubles:
      return "doubles";
    case Arithmetic::chain:
      return "chain";
    case Arithmetic::mpfr:
      return "mpfr";
    case Arithmetic::exact:
      return "exact";
  }
  return "?";
}

std::string_view name(Tier tier) {
  switch (tier) {
    case Tier::structure:
      return "structure";
    case Tier::filter:
      return "filter";
    case Tier::interval:
      return "interval";
    case Tier::mpfr:
      return "mpfr";
    case Tier::exact:
      return "exact";
  }
  return "?";
}

std::string_view name(Predicate predicate) {
  switch (predicate) {
    case Predicate::facing:
      return "facing";
    case Predicate::front:
      return "front";
    case Predicate::turn:
      return "turn";
    case Predicate::turn_constructed:
      return "turn_constructed";
    case Predicate::nearer:
      return "nearer";
    case Predicate::nearer_constructed:
      return "nearer_constructed";
    case Predicate::coplanar:
      return "coplanar";
    case Predicate::along:
      return "along";
    case Predicate::motion:
      return "motion";
    case Predicate::event_order:
      return "event_order";
  }
  return "?";
}

SignCounts& SignCounts::operator+=(const SignCounts& other) {
  for (std::size_t p = 0; p < decided.size(); ++p) {
    for (std::size_t t = 0; t < decided[p].size(); ++t) decided[p][t] += other.decided[p][t];
    wrong[p] += other.wrong[p];
  }
  return *this;
}

}  // namespace provis
