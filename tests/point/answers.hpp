#pragma once
// The engine's answer in the form in which the oracles give theirs.

#include <vector>

#include "provis/point.hpp"
#include "tests/support/case.hpp"

namespace provis::test {

std::vector<bool> visible_flags(const VisibleSet& set);

/// The engine's answer to a case.
std::vector<bool> engine_visible(const Case& c, Arithmetic arithmetic = Arithmetic::chain);

/// Ascending ids.
std::vector<PrimitiveId> ids_of(const std::vector<bool>& visible);

}  // namespace provis::test
