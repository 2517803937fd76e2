#pragma once
// What a closed chain encloses, and whether triangles lie in it.

#include <optional>

#include "src/lod/chain.hpp"

namespace provis::lod {

/// What counts as inside.
enum class Inside {
  any_side,  ///< the winding number is not zero, or on the chain
  fronts,    ///< it is positive; or on the chain, as far as each side of the point shows a side of a triangle
             ///< through it, or has a positive winding number
};

/// A point of the closed triangle, of some area, that is not inside the chain; nothing if it lies inside as a
/// whole, but for a set of no area.
///
/// Requires:   the chain is closed; a RoundUp guard
/// Guarantee:  exact, and complete
std::optional<Point> outside(const Chain& chain, Inside inside, const Vec3d& a, const Vec3d& b,
                             const Vec3d& c);

}  // namespace provis::lod
