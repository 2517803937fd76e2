#pragma once
// A triangle, cut into convex cells by what meets it in its plane.

#include <array>
#include <functional>
#include <vector>

#include "src/lod/point.hpp"

namespace provis::lod {

/// A triangle in the plane of the one that is cut.
struct Cover {
  std::array<Point, 3> corners;
  Sign facing = Sign::positive;  ///< whether it looks the same way
  bool two_sided = false;
};

/// The cells are open, convex, and met by no segment and no border of a cover: what meets them covers them,
/// or touches them in a point. A RoundUp guard must be alive: signs are asked of intervals first.
class PlaneCells {
 public:
  /// Requires:   a triangle of some area
  PlaneCells(const Vec3d& a, const Vec3d& b, const Vec3d& c);

  /// A segment in the plane: cells end at it, as far as it lies inside.
  void add_segment(const Point& from, const Point& to);
  /// A point in the plane that tells nothing of the cell around it.
  void add_contact(const Point& p);
  void add_cover(const Cover& cover);

  /// Called for each cell with an inner point that is no contact and the covers that hold it, until it
  /// returns true.
  using Visit = std::function<bool(const Point& inner, const std::vector<const Cover*>& covers)>;
  /// Returns whether visit did.
  bool any(const Visit& visit) const;

 private:
  /// A point of the plane, and its two coordinates enclosed.
  struct Spot {
    Point at;
    Interval x, y;
  };
  /// a x + b y + c, positive to the left of the way from one point to another; and enclosed.
  struct Line {
    Rational a, b, c;
    Interval around_a, around_b, around_c;
  };
  /// A part of a line that lies in a cell.
  struct Cut {
    Line line;
    Spot from, to;
  };
  struct Laid {
    Cover cover;
    std::array<Spot, 3> corners;
    std::array<Line, 3> edges;  ///< from corner k to the next
  };
  using Polygon = std::vector<Spot>;
  struct Cell {
    Polygon corners;
    std::vector<Cut> cuts;
    std::vector<Spot> contacts;  ///< inner points of the cell
    std::vector<const Laid*> covers;
  };

  Spot spot(const Point& p) const;
  Spot crossing(const Spot& p, const Spot& q, const Line& line) const;
  Line line(const Spot& from, const Spot& to) const;
  Rational height(const Line& line, const Spot& p) const;
  Sign side(const Line& line, const Spot& p) const;
  bool divides(const Line& line, const Polygon& p) const;
  bool clip(Cut& cut, const Line& line, Sign keep) const;
  Polygon clip(const Polygon& p, const Line& line, Sign keep) const;
  Cell part(const Cell& cell, const Line& line, Sign keep) const;
  void add_cut(Cut cut);
  bool holds(const Laid& cover, const Spot& p) const;
  static Point inner_point(const Cell& cell);
  bool any(Cell cell, const Visit& visit) const;

  int i_ = 0, j_ = 1;  ///< the coordinates in which the plane is not seen edge-on
  Sign turn_;          ///< which way the triangle turns in them
  Cell whole_;
  std::array<Line, 3> edges_;  ///< of the whole
  std::vector<Laid> covers_;
};

}  // namespace provis::lod
