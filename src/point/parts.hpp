#pragma once
// The parts of a frame's window, each with the triangles that may be seen in it: what float64 with a bound
// can rule out is gone before anything else is made of a triangle.

#include <span>
#include <vector>

#include "provis/context.hpp"
#include "provis/scene.hpp"
#include "src/point/screen.hpp"

namespace provis {

/// Square rows of equal parts, row by row from the lower left.
class Parts {
 public:
  std::size_t size() const { return begins_.size() - 1; }
  Window window(std::size_t part) const {
    const auto side = static_cast<std::size_t>(grid_.side);
    return grid_.block(static_cast<int>(part % side), static_cast<int>(part / side), 1);
  }
  /// In id order.
  std::span<const PrimitiveId> members(std::size_t part) const {
    return {members_.data() + begins_[part], begins_[part + 1] - begins_[part]};
  }

 private:
  friend class Partition;

  WindowGrid grid_;
  std::vector<std::size_t> begins_{0};
  std::vector<PrimitiveId> members_;
};

/// Leaves out of each part what certainly has no hit there, or lies strictly behind occluders that certainly
/// cover it. Nothing that is visible is left out, and no nearest occluder.
///
/// Throws:     Error::cancelled
Parts make_parts(const Scene& scene, const ViewGeometry& geometry, const Window& window,
                 const Context& context);

}  // namespace provis
