#include "src/point/weld.hpp"

#include <bit>

#include "src/scene/position_hash.hpp"

namespace provis {

Weld::Weld(std::size_t expected) : slots_(std::bit_ceil(2 * expected + 16), 0) {}

std::uint32_t Weld::id(const Vec3d* position) {
  const std::size_t mask = slots_.size() - 1;
  std::size_t s = position_hash(*position) & mask;
  for (; slots_[s] != 0; s = (s + 1) & mask)
    if (*positions_[slots_[s] - 1] == *position) return slots_[s] - 1;
  positions_.push_back(position);
  slots_[s] = static_cast<std::uint32_t>(positions_.size());
  if (2 * positions_.size() > slots_.size()) grow();
  return static_cast<std::uint32_t>(positions_.size() - 1);
}

void Weld::grow() {
  std::vector<std::uint32_t> larger(2 * slots_.size(), 0);
  const std::size_t mask = larger.size() - 1;
  for (const std::uint32_t entry : slots_) {
    if (entry == 0) continue;
    std::size_t s = position_hash(*positions_[entry - 1]) & mask;
    while (larger[s] != 0) s = (s + 1) & mask;
    larger[s] = entry;
  }
  slots_ = std::move(larger);
}

}  // namespace provis
