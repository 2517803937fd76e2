#pragma once
// Simplified versions of a scene that stand in for it where only an upper set is asked for.

#include <memory>
#include <string>
#include <vector>

#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "provis/source.hpp"

namespace provis {

/// An object of the full scene, and what stands for it in the two simplified ones.
struct DetailObject {
  std::string name;                ///< as errors call it
  std::vector<IdRange> full;       ///< its primitives in the full scene
  std::vector<IdRange> occluders;  ///< of the inscribed mesh; may be empty: it then hides nothing
  std::vector<IdRange> shell;      ///< of the circumscribed shell
};

/// One of the three scenes.
struct DetailScene {
  const Scene* scene = nullptr;  ///< outlives the level of detail
  std::string file;              ///< as errors call it
};

/// An inscribed occluder mesh and a circumscribed shell of a scene, proven to be that.
///
/// An object is *hidden* where its whole shell is hidden by what stands for the others; then so are all its
/// full primitives. A full primitive in no object stands for itself, as shell and as occluder.
///
/// Input:      full, occluders, shell: triangles in the same units. Flags of occluders and shell do not
///             matter: an occluder hides from both sides, a shell is seen from both and hides nothing
/// Guarantee:  verified exactly, and complete: what meets these conditions is accepted.
///             Shell: the triangles of each object form a closed oriented surface, edges cut where vertices
///             lie on them, and each full triangle of the object lies where its winding number is not zero,
///             or on it.
///             Occluders: the full opaque triangles of the object form such a surface, and each occluder lies
///             where its winding number is not zero (positive if any of them is single-sided: fronts look
///             outwards), or on it, as far as it shows a side that is there
/// Error:      none: float64 coordinates are taken as exact
/// Degenerate: triangles of zero area are passed over everywhere; surfaces may touch, coincide, penetrate
///             and have several parts
/// Throws:     Error::invalid_input naming file, object and id (out of range; in two objects, or twice in
///             one; an occluder or a shell triangle in no object; an object without shell or without full
///             primitives; a condition that does not hold); Error::unsupported (spheres); Error::cancelled
/// Cost:       about O(F log F) where few triangles meet a surface; parallel; same for any thread count
/// Source:     J. Hladky, H.-P. Seidel, M. Steinberger, The camera offset space, 2019, section 6
class LevelOfDetail {
 public:
  LevelOfDetail(const DetailScene& full, const DetailScene& occluders, const DetailScene& shell,
                const std::vector<DetailObject>& objects, const Context& context = {});
  ~LevelOfDetail();
  LevelOfDetail(LevelOfDetail&&) noexcept;
  LevelOfDetail& operator=(LevelOfDetail&&) noexcept;

  struct Parts;
  const Parts& parts() const { return *parts_; }  ///< for the engine

 private:
  std::unique_ptr<const Parts> parts_;
};

}  // namespace provis
