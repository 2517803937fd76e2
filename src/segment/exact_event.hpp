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

}  // namespace provis
