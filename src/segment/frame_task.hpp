#pragma once
// One frame of a query, and the engines that resolve it.

#include <functional>

#include "src/segment/block.hpp"
#include "src/segment/cluster_tree.hpp"
#include "src/segment/path_projection.hpp"

namespace provis {

struct FrameTask {
  const Scene& scene;
  const PathGeometry& path;
  const PathProjection& projection;
  const BlockedTimes& blocked;
  const ClusterTree* tree = nullptr;  ///< of the fast engine
  const SegmentOptions& options;
  const Context& context;
  int frame = 0;
  /// Takes what blocks saw, in a fixed order, from one thread at a time.
  std::function<void(BlockOutcome&&)> take;
  /// Told what share of the frame was done, from any thread.
  std::function<void(double)> advance;

  /// The pixels that are asked about.
  PixelRect area() const {
    const PixelGrid& all = path.pixels;
    if (options.only) return {0, options.only->row, all.width, 1};
    return {0, 0, all.width, all.height};
  }
  BlockTask block(const PixelRect& area) const;
};

using FrameEngine = void (*)(const FrameTask&);

template <Arithmetic A>
void resolve_frame_plain(const FrameTask& task);
template <Arithmetic A>
void resolve_frame_fast(const FrameTask& task);

}  // namespace provis
