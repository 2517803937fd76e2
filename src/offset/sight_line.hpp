#pragma once
// A segment of sight, made ready to be held against many triangles.

#include <optional>

#include "src/offset/facet.hpp"

namespace provis::offset {

class SightLine {
 public:
  SightLine(const Point& from, const Point& to);

  /// Whether the line through both points passes through the triangle's interior; nullopt where that is not
  /// certain.
  std::optional<bool> aims_at(const Facet& f) const;
  /// The same for the segment.
  std::optional<bool> crosses(const Facet& f) const;

 private:
  Point from_, to_;
  int along_ = 2;       ///< the axis along which the segment is longest
  int i_ = 0, j_ = 1;   ///< the others, in the order in which turns to the left stay such
  bool known_ = false;  ///< false where the segment may be shorter than its enclosure is wide
  Interval slope_i_, slope_j_, length_;
};

}  // namespace provis::offset
