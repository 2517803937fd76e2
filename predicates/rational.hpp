#pragma once
// Exact numbers with division, for points between those of the input.

#include <CGAL/Gmpq.h>

#include "predicates/sign.hpp"

namespace provis {

using Rational = CGAL::Gmpq;

inline Sign sign_of(const Rational& x) { return static_cast<Sign>(static_cast<int>(CGAL::sign(x))); }

}  // namespace provis
