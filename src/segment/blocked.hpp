#pragma once
// Where the camera lies on an occluder: viewpoints that prove nothing (R9, R11).

#include <optional>
#include <utility>
#include <vector>

#include "provis/scene.hpp"
#include "src/segment/exact_event.hpp"

namespace provis {

class BlockedTimes {
 public:
  /// Of a path of positive length; one of length zero has none, for a single viewpoint is R9's point.
  BlockedTimes(const Scene& scene, const Vec3d& from, const Vec3d& to);

  /// Whether no part of positive length lies on an occluder.
  bool empty() const { return parts_.empty(); }

  /// The first part of (begin, end) of positive length that lies on none.
  std::optional<std::pair<ExactTime, ExactTime>> first_gap(const ExactTime& begin,
                                                           const ExactTime& end) const;

  /// Whether the viewpoint at that moment lies on an occluder.
  bool at(const ExactTime& t) const;

 private:
  const Scene& scene_;
  Vec3d from_, to_;
  std::vector<PrimitiveId> near_;                       ///< occluders that the path may meet
  std::vector<std::pair<ExactTime, ExactTime>> parts_;  ///< sorted, not overlapping
};

}  // namespace provis
