#pragma once
// Whether a triangle may meet a closed box.

#include "src/scene/box_tree.hpp"

namespace provis::lod {

/// False only if a plane certainly separates the two. For boxes of some volume and triangles of some area
/// exact; where one of them is flat it may be true of what does not meet. A RoundUp guard must be alive.
bool may_meet(const Box& box, const Vec3d& a, const Vec3d& b, const Vec3d& c);

}  // namespace provis::lod
