#pragma once
// Lines and directions of every kind over one random input, as an engine would make them.

#include <deque>
#include <vector>

#include "predicates/signs.hpp"
#include "tests/predicates/near_degenerate.hpp"
#include "tests/predicates/reference.hpp"

namespace provis::test {

/// Keeps what lines and directions point into, so it stays where it is.
class Drawing {
 public:
  Drawing(NearFamily family, std::uint64_t seed);
  Drawing(const Drawing&) = delete;
  Drawing& operator=(const Drawing&) = delete;

  Input input;
  Reference reference;
  std::deque<Line> lines;            ///< every kind; depth lines only where two triangles are not edge-on
  std::deque<Direction> directions;  ///< every kind; crossings of pairs of the lines

  /// Pairs (line, direction), as many as asked, with repetition.
  struct Pair {
    Line line;
    Direction direction;
  };
  std::vector<Pair> pairs(int count);

  /// Fills in the float64 shadows of everything in this policy's number.
  template <Arithmetic A>
  void cast_shadows(const Signs<A>& signs);

 private:
  std::uint32_t point_id(std::size_t index) const;
  bool find_triangle(std::array<std::size_t, 3>& corners);
  void make_edges_and_borders();
  void make_depth_lines();
  void make_directions();

  Random random_;
};

template <Arithmetic A>
void Drawing::cast_shadows(const Signs<A>& signs) {
  for (Line& l : lines) l.approx = signs.shadow(l);
  for (Direction& d : directions) {
    d.approx = signs.shadow(d);
    // Engines cross the shadows of the lines instead of evaluating their definition; both must hold.
    if (d.kind != DirectionKind::crossing || random_.chance(50)) continue;
    Approx a = cross(d.lines[0]->approx, d.lines[1]->approx);
    if (d.negated) a.v = -a.v;
    d.approx = prepare(a);
  }
}

}  // namespace provis::test
