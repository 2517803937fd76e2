#pragma once
// Polygons of the window in plain float64: they say where to look, and prove nothing.

#include <boost/container/static_vector.hpp>

#include "src/point/window_function.hpp"

namespace provis {

struct PolygonCorner {
  double x = 0, y = 0;
};

/// Convex, anticlockwise. Corners beyond the capacity are left out: that is a smaller polygon.
class Polygon {
 public:
  explicit Polygon(const Window& w) : corners_{{w.x0, w.y0}, {w.x1, w.y0}, {w.x1, w.y1}, {w.x0, w.y1}} {}

  bool empty() const { return corners_.size() < 3; }
  double area() const;
  PolygonCorner middle() const;
  /// The part where sign * f is positive.
  Polygon clipped(const WindowFunction& f, double sign) const;

 private:
  Polygon() = default;
  void add(const PolygonCorner& c) {
    if (corners_.size() < corners_.capacity()) corners_.push_back(c);
  }

  boost::container::static_vector<PolygonCorner, 16> corners_;
};

inline double Polygon::area() const {
  const auto& p = corners_;
  double twice = 0;
  for (std::size_t k = 2; k < p.size(); ++k)
    twice += (p[k - 1].x - p[0].x) * (p[k].y - p[0].y) - (p[k].x - p[0].x) * (p[k - 1].y - p[0].y);
  return twice / 2;
}

inline PolygonCorner Polygon::middle() const {
  PolygonCorner sum;
  for (const PolygonCorner& c : corners_) sum = {sum.x + c.x, sum.y + c.y};
  const auto n = static_cast<double>(corners_.size());
  return {sum.x / n, sum.y / n};
}

inline Polygon Polygon::clipped(const WindowFunction& f, double sign) const {
  const auto& p = corners_;
  Polygon out;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const PolygonCorner &a = p[k], &b = p[(k + 1) % p.size()];
    const double fa = sign * f.at(a.x, a.y), fb = sign * f.at(b.x, b.y);
    if (fa >= 0) out.add(a);
    if ((fa > 0 && fb < 0) || (fa < 0 && fb > 0)) {
      const double t = fa / (fa - fb);
      out.add({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return out;
}

}  // namespace provis
