#pragma once
// What both engines share: a frame is resolved by rows of blocks, in parallel, and reported in order.

#include <algorithm>
#include <vector>

#include "provis/error.hpp"
#include "src/point/guard.hpp"
#include "src/scene/parallel.hpp"
#include "src/segment/frame_task.hpp"

namespace provis {

inline constexpr int block_side = 16;

/// feed(block, range) adds what may be seen in a block; see Block::run.
template <Arithmetic A, class Feed>
void resolve_rows(const FrameTask& task, int block_width, const Feed& feed) {
  const PixelRect pixels = task.area();
  const auto rows = static_cast<std::size_t>((pixels.height + block_side - 1) / block_side);
  // Lists are long: only so many rows of them exist at a time.
  const std::size_t batch =
      task.options.on_pixel ? 2 * static_cast<std::size_t>(thread_count(task.context)) : rows;
  for (std::size_t first = 0; first < rows; first += batch) {
    const std::size_t count = std::min(batch, rows - first);
    std::vector<std::vector<BlockOutcome>> outcomes(count);
    parallel_queue(count, [&](std::size_t k) {
      const int below = static_cast<int>(first + k) * block_side;
      const int top = pixels.row + below, height = std::min(block_side, pixels.height - below);
      const RoundingGuard<A> guard;
      SignCounts signs;
      Block<A> block(signs, task.path);
      for (int left = 0; left < pixels.width; left += block_width) {
        if (task.context.cancelled()) throw Error(Error::Code::cancelled, "segment", "interrupted");
        const BlockTask what = task.block({left, top, std::min(block_width, pixels.width - left), height});
        BlockOutcome& outcome = outcomes[k].emplace_back();
        block.run(
            what, [&](const TimeRange& range) { feed(block, what.area, range); }, outcome);
      }
      outcomes[k].back().signs += signs;
      task.advance(1.0 / static_cast<double>(rows));
    });
    for (std::vector<BlockOutcome>& row : outcomes) {
      std::vector<PixelSights> sights;
      for (BlockOutcome& o : row) {
        std::move(o.sights.begin(), o.sights.end(), std::back_inserter(sights));
        o.sights.clear();
        task.take(std::move(o));
      }
      std::stable_sort(sights.begin(), sights.end(),
                       [](const PixelSights& a, const PixelSights& b) { return a.row < b.row; });
      if (task.options.on_pixel)
        for (const PixelSights& s : sights) task.options.on_pixel(s);
    }
  }
}

}  // namespace provis
