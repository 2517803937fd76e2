#pragma once
// The upper set of a full scene, by what stands for it.

#include "provis/cell.hpp"
#include "provis/level_of_detail.hpp"
#include "src/scene/progress_meter.hpp"

namespace provis::lod {

/// What is asked of the full scene.
struct Asked {
  std::vector<char> wanted;  ///< by id: what is to be decided
  std::vector<char> seen;    ///< by id: proven to be visible; so its object is not hidden either
};

struct CoarseUpper {
  std::vector<char> reached;  ///< by id of the full scene: of those wanted, those that are not proven hidden
  DetailStats counts;
  OffsetStats stats;
};

/// Looks at shells, and at what is in no object, past inscribed occluders and what is in no object.
///
/// Guarantee:  conservative, as offset::reach is of the full scene (README.md)
/// Throws:     Error::cancelled
CoarseUpper reach(const LevelOfDetail& detail, const ViewCell& cell, const Asked& asked,
                  const PixelGrid& pixels, int refinements, const Context& context, ProgressMeter& meter);

}  // namespace provis::lod
