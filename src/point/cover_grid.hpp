#pragma once
// For every cell of the window the depth of the nearest occluder that certainly covers it: hierarchical z
// with a proof.

#include <atomic>
#include <vector>

#include "src/point/screen.hpp"
#include "src/point/window_function.hpp"

namespace provis {

/// Cells [i0, i1] x [j0, j1], both ends included.
struct CellRange {
  int i0 = 0, i1 = 0, j0 = 0, j1 = 0;
};

/// Where one occluder has hits, and how deep: three lines, all positive inside, and its depth times at_eye.
struct Cover {
  WindowFunction edges[3];
  WindowFunction depth;
  Ball at_eye;
};

/// Fill it from any threads, then settle it once, then ask. What it knows does not depend on the order.
class CoverGrid {
 public:
  explicit CoverGrid(const WindowGrid& grid);

  /// Notes every cell of the range that the occluder certainly covers.
  void add(const Cover& cover, const Screen& screen, const CellRange& cells);
  void settle();

  /// Whether something with hits in these cells only, and nowhere nearer than depth, lies strictly behind
  /// covers everywhere.
  bool hides(const CellRange& cells, float depth) const;

 private:
  struct Level {
    int side;
    std::vector<std::atomic<float>> nearest;
  };

  /// open: edges that do not hold all of what is around the block.
  void descend(const Cover& cover, const Screen& screen, std::size_t level, int i, int j, unsigned open);
  float at(std::size_t level, int i, int j) const {
    const Level& l = levels_[level];
    return l
        .nearest[static_cast<std::size_t>(j) * static_cast<std::size_t>(l.side) + static_cast<std::size_t>(i)]
        .load(std::memory_order_relaxed);
  }
  std::atomic<float>& ref(std::size_t level, int i, int j) {
    Level& l = levels_[level];
    return l.nearest[static_cast<std::size_t>(j) * static_cast<std::size_t>(l.side) +
                     static_cast<std::size_t>(i)];
  }

  WindowGrid grid_;
  std::vector<Level> levels_;  ///< from cells to the whole window
};

}  // namespace provis
