#pragma once
// Views for generated scenes: eyes and windows that coincide with what is there.

#include "tests/support/case.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

/// Chooses eye, projection, frame and window for the scene in c and appends them to its name.
void choose_view(Case& c, Random& random);

}  // namespace provis::test
