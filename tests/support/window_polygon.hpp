#pragma once
// Convex polygons in window coordinates (x, y), held exactly as lines and their crossings.

#include <memory>
#include <vector>

#include "provis/view.hpp"
#include "tests/support/exact.hpp"

namespace provis::test {

/// The function a x + b y + c, given by (a, b, c): inside is where it is positive.
using Line = std::shared_ptr<const Shadowed>;

Line make_line(Integer3 coefficients);

/// An axis-parallel box that is never too small.
struct Box {
  Bounds x, y;
};

bool overlap(const Box& a, const Box& b);
double overlap_area(const Box& a, const Box& b);

/// A convex polygon of positive area, or empty.
class WindowPolygon {
 public:
  WindowPolygon() = default;
  explicit WindowPolygon(const Window& window);

  bool empty() const { return sides_.empty(); }
  const Box& box() const { return box_; }

  /// The part where side * line >= 0, empty unless it has positive area. A strictly convex polygon has such
  /// a part exactly if one of its corners lies strictly on that side.
  WindowPolygon clipped(const Line& line, int side) const;

  /// Corners as (x, y, w), w > 0: the point (x / w, y / w).
  std::vector<Integer3> corners() const;

  /// A point of the interior whose coordinates are dyadic: (x, y, w) with w a power of two.
  Integer3 dyadic_inner_point() const;

  double rounded_area() const;

 private:
  struct Corner {
    explicit Corner(Integer3 xyw);
    Shadowed at;
    Box box;
  };
  struct Side {
    std::shared_ptr<const Corner> start;
    Line line;  // runs to the next side's start; its inside may be on either side
  };

  static std::shared_ptr<const Corner> crossing(const Line& a, const Line& b);
  void fit_box();

  std::vector<Side> sides_;
  Box box_{};
};

}  // namespace provis::test
