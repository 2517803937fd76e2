#include "src/point/cover_grid.hpp"

#include <limits>

#include "src/scene/parallel.hpp"

namespace provis {
namespace {

void raise(std::atomic<float>& known, float depth) {
  float old = known.load(std::memory_order_relaxed);
  while (old < depth && !known.compare_exchange_weak(old, depth, std::memory_order_relaxed)) {
  }
}

/// The finest level on which the range takes at most two blocks in each direction.
std::size_t level_of(const CellRange& c) {
  std::size_t level = 0;
  while (std::max((c.i1 >> level) - (c.i0 >> level), (c.j1 >> level) - (c.j0 >> level)) > 1) ++level;
  return level;
}

}  // namespace

CoverGrid::CoverGrid(const WindowGrid& grid) : grid_(grid) {
  for (int side = grid.side; side > 0; side /= 2) {
    Level& level = levels_.emplace_back();
    level.side = side;
    level.nearest =
        std::vector<std::atomic<float>>(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (auto& cell : level.nearest)
      cell.store(-std::numeric_limits<float>::infinity(), std::memory_order_relaxed);
  }
}

void CoverGrid::add(const Cover& cover, const Screen& screen, const CellRange& cells) {
  const std::size_t level = level_of(cells);
  for (int j = cells.j0 >> level; j <= cells.j1 >> level; ++j)
    for (int i = cells.i0 >> level; i <= cells.i1 >> level; ++i) descend(cover, screen, level, i, j, 7);
}

/// A block is taken as a whole where the cover's depth hardly differs within it; what is known of a block is
/// known of its cells.
void CoverGrid::descend(const Cover& cover, const Screen& screen, std::size_t level, int i, int j,
                        unsigned open) {
  const int n = 1 << level;
  const Window block = grid_.block(i * n, j * n, n);
  // It would change nothing here: so the order of covers does not matter.
  if (!(at(level, i, j) < screen.depth_bound(cover.depth.highest(block), cover.at_eye))) return;
  for (unsigned k = 0; k < 3; ++k) {
    if (!(open & 1u << k)) continue;
    if (cover.edges[k].highest(block) < 0) return;
    if (cover.edges[k].lowest(block) > 0) open &= ~(1u << k);
  }
  if (open == 0) {
    const double lowest = cover.depth.lowest(block);
    const double differs = cover.depth.highest(block) - lowest;
    if (level == 0 || !(differs > std::fabs(lowest) / 64)) {
      raise(ref(level, i, j), screen.depth_bound(lowest, cover.at_eye));
      return;
    }
  }
  if (level == 0) return;
  for (int k = 0; k < 4; ++k) descend(cover, screen, level - 1, 2 * i + k % 2, 2 * j + k / 2, open);
}

void CoverGrid::settle() {
  for (std::size_t level = levels_.size() - 1; level-- > 0;)
    parallel_for(static_cast<std::size_t>(levels_[level].side), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < levels_[level].side; ++i) raise(ref(level, i, j), at(level + 1, i / 2, j / 2));
    });
  for (std::size_t level = 1; level < levels_.size(); ++level)
    parallel_for(static_cast<std::size_t>(levels_[level].side), [&](std::size_t row) {
      const int j = static_cast<int>(row);
      for (int i = 0; i < levels_[level].side; ++i) {
        float least = std::numeric_limits<float>::infinity();
        for (int k = 0; k < 4; ++k) least = std::min(least, at(level - 1, 2 * i + k % 2, 2 * j + k / 2));
        ref(level, i, j).store(least, std::memory_order_relaxed);
      }
    });
}

bool CoverGrid::hides(const CellRange& c, float depth) const {
  const auto hidden_at = [&](std::size_t level) {
    for (int j = c.j0 >> level; j <= c.j1 >> level; ++j)
      for (int i = c.i0 >> level; i <= c.i1 >> level; ++i)
        if (!(depth < at(level, i, j))) return false;
    return true;
  };
  // Finer levels see past what a coarse block holds beside the range.
  const std::size_t coarse = level_of(c), finest = coarse > 2 ? coarse - 2 : 0;
  for (std::size_t level = coarse + 1; level-- > finest;)
    if (hidden_at(level)) return true;
  return false;
}

}  // namespace provis
