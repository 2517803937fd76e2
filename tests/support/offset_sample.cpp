#include "tests/support/offset_sample.hpp"

#include <gmpxx.h>

#include <array>
#include <optional>

namespace provis::test {

namespace {

using Rational = mpq_class;

/// A point of the face with the distance at which a ray from it meets a triangle's plane.
struct Offset {
  Rational u, v;
};
using Polygon = std::vector<Offset>;

/// a u + b v + c
struct Linear {
  Rational a, b, c;
  Rational operator()(const Offset& o) const { return a * o.u + b * o.v + c; }
};

/// What of a convex polygon lies where the function is not negative; empty unless it has area.
Polygon clipped(const Polygon& p, const Linear& f) {
  Polygon out;
  bool inside = false;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Offset &a = p[k], &b = p[(k + 1) % p.size()];
    const Rational fa = f(a), fb = f(b);
    inside = inside || fa > 0;
    if (fa >= 0) out.push_back(a);
    if ((fa > 0 && fb < 0) || (fa < 0 && fb > 0)) {
      const Rational s = fa / (fa - fb);
      out.push_back({a.u + s * (b.u - a.u), a.v + s * (b.v - a.v)});
    }
  }
  return inside ? out : Polygon{};
}

/// A triangle in the offset space.
struct Shape {
  bool occludes = false;
  std::array<Linear, 3> sides;  ///< covered where none is negative
  Linear distance;
};

struct Corner {
  Rational u, v, distance;
};

double at(const Vec3d& p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/// The function through three values at three points that are not on a line.
Linear through(const std::array<Corner, 3>& c, const std::array<Rational, 3>& value,
               const Rational& doubled_area) {
  const Rational a =
      ((value[1] - value[0]) * (c[2].v - c[0].v) - (value[2] - value[0]) * (c[1].v - c[0].v)) / doubled_area;
  const Rational b =
      ((value[2] - value[0]) * (c[1].u - c[0].u) - (value[1] - value[0]) * (c[2].u - c[0].u)) / doubled_area;
  return {a, b, value[0] - a * c[0].u - b * c[0].v};
}

class Sample {
 public:
  Sample(const ViewCell& cell, int axis, bool upper, double x, double y)
      : axis_(axis), sign_(upper ? 1 : -1), height_(at(upper ? cell.upper : cell.lower, axis)), x_(x), y_(y) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Rational u0 = at(cell.lower, i), u1 = at(cell.upper, i), v0 = at(cell.lower, j),
                   v1 = at(cell.upper, j);
    rectangle_ = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
  }

  std::optional<Shape> shape(const SceneArrays& s, std::size_t t) const {
    std::array<Corner, 3> c;
    for (std::size_t k = 0; k < 3; ++k) c[k] = corner(s.vertices[s.triangles[t][k]]);
    const Rational area = (c[1].u - c[0].u) * (c[2].v - c[0].v) - (c[2].u - c[0].u) * (c[1].v - c[0].v);
    if (area == 0) return std::nullopt;
    // Looking along the axis with (i, j) as right-handed axes, a front is clockwise.
    const bool front = (area > 0) == (sign_ < 0);
    if ((s.triangle_flags[t] & single_sided) && !front) return std::nullopt;
    Shape shape;
    shape.occludes = !(s.triangle_flags[t] & see_through);
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Rational, 3> weight{0, 0, 0};
      weight[k] = 1;
      shape.sides[k] = through(c, weight, area);
    }
    shape.distance = through(c, {c[0].distance, c[1].distance, c[2].distance}, area);
    return shape;
  }

  /// Where it is covered, at distances above zero.
  Polygon region(const Shape& s) const {
    Polygon p = clipped(rectangle_, s.distance);
    for (const Linear& side : s.sides) p = clipped(p, side);
    return p;
  }

 private:
  /// The offset from which the sample's ray meets the point.
  Corner corner(const Vec3d& p) const {
    const Rational distance = sign_ * (Rational(at(p, axis_)) - height_);
    return {Rational(at(p, (axis_ + 1) % 3)) - distance * x_,
            Rational(at(p, (axis_ + 2) % 3)) - distance * y_, distance};
  }

  int axis_, sign_;
  Rational height_, x_, y_;
  Polygon rectangle_;
};

/// Convex parts of the polygon less where the occluder is nearer. A difference of distances that is zero
/// everywhere means one plane, and that nothing is nearer.
std::vector<Polygon> less(const Polygon& p, const Shape& target, const Shape& occluder) {
  std::vector<Linear> cuts(occluder.sides.begin(), occluder.sides.end());
  cuts.push_back(occluder.distance);
  cuts.push_back({target.distance.a - occluder.distance.a, target.distance.b - occluder.distance.b,
                  target.distance.c - occluder.distance.c});
  std::vector<Polygon> left;
  Polygon rest = p;
  for (const Linear& f : cuts) {
    Polygon out = clipped(rest, {-f.a, -f.b, -f.c});
    if (!out.empty()) left.push_back(std::move(out));
    rest = clipped(rest, f);
    if (f.a == 0 && f.b == 0 && f.c == 0) return {p};
    if (rest.empty()) break;
  }
  return left;
}

}  // namespace

std::vector<bool> offset_sample(const SceneArrays& scene, const ViewCell& cell, int axis, bool upper,
                                double x, double y) {
  const Sample sample(cell, axis, upper, x, y);
  std::vector<std::optional<Shape>> shapes;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) shapes.push_back(sample.shape(scene, t));
  std::vector<bool> visible;
  for (std::size_t t = 0; t < shapes.size(); ++t) {
    std::vector<Polygon> left;
    if (shapes[t])
      if (Polygon p = sample.region(*shapes[t]); !p.empty()) left.push_back(std::move(p));
    for (std::size_t o = 0; o < shapes.size() && !left.empty(); ++o) {
      if (o == t || !shapes[o] || !shapes[o]->occludes) continue;
      std::vector<Polygon> next;
      for (const Polygon& p : left)
        for (Polygon& q : less(p, *shapes[t], *shapes[o])) next.push_back(std::move(q));
      left = std::move(next);
    }
    visible.push_back(!left.empty());
  }
  return visible;
}

}  // namespace provis::test
