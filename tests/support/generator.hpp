#pragma once
// Degenerate scenes and views on purpose: what breaks visibility code is coincidence, so it is generated.

#include <cstdint>
#include <vector>

#include "tests/support/case.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

/// A case of 1 to about 60 triangles (mostly fewer than 25) whose family, size, flags, nudges, scale,
/// position and view are all functions of the seed, the same on every machine.
///
/// Guarantee: finite coordinates; windows of positive extent; linearly independent frame vectors
Case generate(std::uint64_t seed);

/// Fills c with the triangles of one family, or of up to three as long as the scene stays small.
void build_scene(Case& c, Random& random);

/// n triangles with random corners in general position, seen by a pinhole from outside or inside.
Case random_soup(std::uint64_t seed, int n);

}  // namespace provis::test
