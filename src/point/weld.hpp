#pragma once
// Equal positions get equal ids: what lets structure decide before arithmetic does.

#include <cstdint>
#include <vector>

#include "provis/vec3.hpp"

namespace provis {

/// A table from positions to dense ids, in order of first appearance. +0 and -0 are one position.
class Weld {
 public:
  explicit Weld(std::size_t expected);

  /// The id of the position; the pointer must outlive the table.
  std::uint32_t id(const Vec3d* position);

  /// The first position of each id.
  const std::vector<const Vec3d*>& positions() const { return positions_; }

 private:
  void grow();

  std::vector<std::uint32_t> slots_;  ///< id + 1, or 0 where empty; a power of two
  std::vector<const Vec3d*> positions_;
};

}  // namespace provis
