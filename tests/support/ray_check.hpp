#pragma once
// Re-checks witnesses (R11): one exact ray against all triangles of a scene. Shares no code with the engine.

#include <memory>
#include <string>

#include "provis/scene.hpp"
#include "provis/view.hpp"
#include "provis/visible_set.hpp"

namespace provis::test {

/// Holds the scene's triangles in a tree of boxes, so that many witnesses are checked quickly. The scene
/// must outlive it.
class RayChecker {
 public:
  RayChecker(const SceneArrays& scene, const PointView& view);
  RayChecker(const Scene& scene, const PointView& view) : RayChecker(scene.arrays(), view) {}
  ~RayChecker();

  /// Empty if the witness proves its primitive visible, otherwise the reason why it does not.
  ///
  /// A witness holds iff its ray belongs to the view (closed window), hits the relative interior of its
  /// primitive from a visible side at a distance > 0, and every opaque triangle that shows an occluding
  /// side and is not coplanar with the primitive misses the closed segment from origin to hit. A triangle
  /// whose plane holds the eye, is parallel to a parallel view or is its window's plane, occludes nothing
  /// (R6).
  std::string refuse(const Witness& witness) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// One witness: RayChecker(scene, view).refuse(witness).empty().
bool ray_check(const Scene& scene, const PointView& view, const Witness& witness);

}  // namespace provis::test
