#pragma once
// The exact tier's number: a dyadic rational of any length, closed under +, - and *.

#include <CGAL/Mpzf.h>

#include "predicates/sign.hpp"

namespace provis {

using ExactNumber = CGAL::Mpzf;

inline Sign sign_of(const ExactNumber& x) {
  const int s = static_cast<int>(x.sign());
  return s > 0 ? Sign::positive : s < 0 ? Sign::negative : Sign::zero;
}

}  // namespace provis
