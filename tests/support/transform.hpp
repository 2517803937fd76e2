#pragma once
// Changes to a case that must not change the answer (semantics.md, "Invariances").

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "tests/support/case.hpp"

namespace provis::test {

/// A changed case. Triangle i of the original became the triangles parts[i] of the changed one: i is
/// visible iff one of its parts is.
struct Variant {
  Case changed;
  std::vector<std::vector<PrimitiveId>> parts;
};

/// The answer for the original that follows from the answer for the changed case.
std::vector<bool> pull_back(const Variant& variant, const std::vector<bool>& visible_in_changed);

Variant permute_triangles(const Case& c, std::uint64_t seed);

/// Rotates the three corners of each triangle by a random amount; windings stay.
Variant rotate_corners(const Case& c, std::uint64_t seed);

/// Gives each triangle three vertices of its own.
Variant split_vertices(const Case& c);

/// Multiplies scene, eye and, where lengths matter (parallel), frame vectors by 2^exponent.
/// Nothing where a number would over- or underflow.
std::optional<Variant> scale(const Case& c, int exponent);

/// Moves scene and eye together; nothing where one sum is not exactly representable.
std::optional<Variant> translate(const Case& c, const Vec3d& by);

/// New coordinate k is old coordinate axes[k]; an odd permutation is a mirror image, so it swaps windings.
Variant permute_axes(const Case& c, const std::array<int, 3>& axes);

/// Negates one coordinate of scene, eye and frame vectors, and swaps windings.
Variant mirror(const Case& c, int axis);

/// Appends one opaque two-sided triangle. Not an invariance: no other triangle may become visible.
Variant add_triangle(const Case& c, std::uint64_t seed);

/// Cuts triangles at the midpoint of an edge where it is exactly representable and lies on the edge
/// without rounding; nothing where no triangle can be cut into two parts of positive area.
std::optional<Variant> cut_triangles(const Case& c, std::uint64_t seed);

}  // namespace provis::test
