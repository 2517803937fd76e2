#pragma once
// A set of oriented triangles, and how often it winds around a point.

#include <span>
#include <vector>

#include "provis/cell.hpp"
#include "src/lod/point.hpp"
#include "src/scene/box_tree.hpp"

namespace provis::lod {

/// The winding number next to a point.
struct Winding {
  int number = 0;   ///< of all points close to it in the direction
  Vec3d direction;  ///< in the plane of no triangle that the point lies on
};

/// Triangles of one scene, without those of zero area. Chains of zero area bound nothing, so leaving them out
/// changes neither boundary nor winding.
class Chain {
 public:
  Chain(const Scene& scene, std::vector<PrimitiveId> triangles);

  const Scene& scene() const { return *scene_; }
  std::span<const PrimitiveId> triangles() const { return triangles_; }
  const BoxTree& tree() const { return tree_; }

  /// Requires:   the chain is closed; p lies on no edge of it; a RoundUp guard
  /// Guarantee:  exact; 1 inside of a surface whose fronts look outwards
  Winding winding(const Point& p) const;

  /// Whether a viewpoint of the cell may be inside: a triangle meets the closed box, or the winding number
  /// there is not zero. False is certain; true may be caution where the cell is flat.
  ///
  /// Requires:   the chain is closed; a RoundUp guard
  bool may_hold_part_of(const ViewCell& cell) const;

 private:
  const Scene* scene_;
  std::vector<PrimitiveId> triangles_;
  BoxTree tree_;
};

}  // namespace provis::lod
