#pragma once
// Changes that make a scene nastier: nudges, flags, windings, degenerate triangles, scales, far origins.

#include <string>

#include "tests/support/case.hpp"
#include "tests/support/random.hpp"

namespace provis::test {

/// Changes to the scene alone, each taken or left by chance; what was done is appended to the name.
void disturb_scene(Case& c, Random& random);

/// Changes to scene and view together (scale, translation), rounded once per coordinate where inexact.
void move_case(Case& c, Random& random);

/// Moves each coordinate by one ulp up or down, or not at all.
void nudge(Vec3d& v, Random& random);

}  // namespace provis::test
