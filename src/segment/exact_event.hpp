#pragma once
// Events as exact rational numbers.

#include <CGAL/Gmpq.h>

#include <string>

#include "predicates/path.hpp"

namespace provis {

using ExactTime = CGAL::Gmpq;

/// The root. Requires: it has one.
ExactTime exact_root(const PathGeometry& path, const Pixel& at, const Motion& motion);

/// "p/q" in lowest terms, q > 0.
std::string text(const ExactTime& t);

/// How many of the moments (2 k + 1) / (2 count), k from 0 to count - 1, lie before the time "p/q".
int moments_before(const std::string& time, int count);

}  // namespace provis
