#pragma once
// What is known of each cell of a leaf from outside, side by side in memory: most cells are passed by on the
// strength of it.

#include <algorithm>
#include <cmath>
#include <vector>

#include "src/point/window_function.hpp"

namespace provis {

struct CellOutline {
  Window box;
  double floor = -HUGE_VAL;  ///< what is nowhere as near is hidden in all of the cell
};

class CellOutlines {
 public:
  CellOutline operator[](std::size_t k) const;
  void clear();
  void push_back(const CellOutline& o);
  void set(std::size_t k, const CellOutline& o);
  /// The last takes the place of cell k.
  void remove(std::size_t k);

  /// The least floor.
  double floor() const;
  /// Appends, in order, the cells that something in a box may touch that is nowhere nearer than a depth.
  void append_touched(const Window& box, double nearest, std::vector<std::uint32_t>& cells) const;

 private:
  static constexpr std::size_t width = 2;  ///< what every processor of the kind compares at once
  using Lanes [[gnu::vector_size(width * sizeof(double))]] = double;
  struct Block {
    Lanes x0, x1, y0, y1, floor;
  };

  /// Fills the last block. Nothing touches it, not even what has an infinite box, for NaN is on no side.
  static constexpr CellOutline none{{NAN, NAN, NAN, NAN}, HUGE_VAL};

  std::vector<Block> blocks_;
  std::size_t size_ = 0;
};

inline CellOutline CellOutlines::operator[](std::size_t k) const {
  const Block& b = blocks_[k / width];
  const std::size_t i = k % width;
  return {{b.x0[i], b.x1[i], b.y0[i], b.y1[i]}, b.floor[i]};
}

inline void CellOutlines::clear() {
  blocks_.clear();
  size_ = 0;
}

inline void CellOutlines::set(std::size_t k, const CellOutline& o) {
  Block& b = blocks_[k / width];
  const std::size_t i = k % width;
  b.x0[i] = o.box.x0;
  b.x1[i] = o.box.x1;
  b.y0[i] = o.box.y0;
  b.y1[i] = o.box.y1;
  b.floor[i] = o.floor;
}

inline void CellOutlines::push_back(const CellOutline& o) {
  if (size_ % width == 0) {
    blocks_.emplace_back();
    for (std::size_t k = 1; k < width; ++k) set(size_ + k, none);
  }
  set(size_++, o);
}

inline void CellOutlines::remove(std::size_t k) {
  set(k, (*this)[--size_]);
  set(size_, none);
  if (size_ % width == 0) blocks_.pop_back();
}

inline double CellOutlines::floor() const {
  Lanes least = Lanes{} + HUGE_VAL;
  for (const Block& b : blocks_) least = b.floor < least ? b.floor : least;
  return std::min(least[0], least[1]);
}

inline void CellOutlines::append_touched(const Window& box, double nearest,
                                         std::vector<std::uint32_t>& cells) const {
  const Lanes x0 = Lanes{} + box.x0, x1 = Lanes{} + box.x1, y0 = Lanes{} + box.y0, y1 = Lanes{} + box.y1;
  const std::size_t count = blocks_.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Block& b = blocks_[k];
    const auto touched = (b.floor <= nearest) & (b.x0 <= x1) & (b.x1 >= x0) & (b.y0 <= y1) & (b.y1 >= y0);
    if (!(touched[0] | touched[1])) continue;
    for (std::size_t i = 0; i < width; ++i)
      if (touched[i]) cells.push_back(static_cast<std::uint32_t>(width * k + i));
  }
}

}  // namespace provis
