#pragma once
// One side of an edge's line: the segments to a part of a triangle that pass it there.

#include <array>
#include <optional>

#include "src/offset/fusion.hpp"

namespace provis::offset {

/// Of the segments from o on a face to p in a polygon, those for which det[a - o, b - o, p - o] has one sign,
/// a b being an edge. The determinant is linear in o and in p.
class Side {
 public:
  Side(const Face& face, const Mesh::Edge& line, bool positive)
      : face_(face), line_(line), positive_(positive) {}

  /// Whether no segment of this side meets the edge: from everywhere on the face both its ends lie on the
  /// other side or on the line. Exact.
  bool leaves_out(const Mesh::Edge& edge) const;

  struct Segment {
    Point from, to;
  };
  /// An inner segment of this side; nothing where it is not certain that the side is connected, or that there
  /// is one.
  std::optional<Segment> some_segment(const Polygon& polygon) const;

 private:
  const Face& face_;
  const Mesh::Edge& line_;
  bool positive_;
};

}  // namespace provis::offset
