#include "tests/support/offset_sample.hpp"

#include <gmpxx.h>

#include <algorithm>
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

using Direction = Vec3<Rational>;

template <class N>
N at(const Vec3<N>& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

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
  Sample(const ViewCell& cell, int axis, bool upper, const Direction& d)
      : axis_(axis),
        sign_(upper ? 1 : -1),
        height_(at(upper ? cell.upper : cell.lower, axis)),
        x_(at(d, (axis + 1) % 3) / (sign_ * at(d, axis))),
        y_(at(d, (axis + 2) % 3) / (sign_ * at(d, axis))) {
    const int i = (axis + 1) % 3, j = (axis + 2) % 3;
    const Rational u0 = at(cell.lower, i), u1 = at(cell.upper, i), v0 = at(cell.lower, j),
                   v1 = at(cell.upper, j);
    rectangle_ = {{u0, v0}, {u1, v0}, {u1, v1}, {u0, v1}};
  }

  /// Nothing where it is met edge-on, or from a side that it has not.
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

  /// The sides of an occluder in the plane of the face.
  std::optional<std::array<Linear, 3>> flat(const SceneArrays& s, std::size_t t) const {
    SceneArrays both = s;
    both.triangle_flags[t] &= static_cast<std::uint8_t>(~single_sided);
    if (s.triangle_flags[t] & see_through) return std::nullopt;
    for (std::size_t k = 0; k < 3; ++k)
      if (at(s.vertices[s.triangles[t][k]], axis_) != height_) return std::nullopt;
    const std::optional<Shape> shape = this->shape(both, t);
    if (!shape) return std::nullopt;
    return shape->sides;
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

/// Convex parts of the polygon less where no function is negative; all of it where one is zero everywhere.
std::vector<Polygon> less(const Polygon& p, const std::vector<Linear>& cuts) {
  std::vector<Polygon> left;
  Polygon rest = p;
  for (const Linear& f : cuts) {
    if (f.a == 0 && f.b == 0 && f.c == 0) return {p};
    Polygon out = clipped(rest, {-f.a, -f.b, -f.c});
    if (!out.empty()) left.push_back(std::move(out));
    rest = clipped(rest, f);
    if (rest.empty()) break;
  }
  return left;
}

std::vector<Polygon> less(const std::vector<Polygon>& parts, const std::vector<Linear>& cuts) {
  std::vector<Polygon> left;
  for (const Polygon& p : parts)
    for (Polygon& q : less(p, cuts)) left.push_back(std::move(q));
  return left;
}

/// Where the occluder is hit before the target. A difference of distances that is zero everywhere means one
/// plane, and that nothing is nearer.
std::vector<Linear> before(const Shape& target, const Shape& occluder) {
  std::vector<Linear> cuts(occluder.sides.begin(), occluder.sides.end());
  cuts.push_back(occluder.distance);
  cuts.push_back({target.distance.a - occluder.distance.a, target.distance.b - occluder.distance.b,
                  target.distance.c - occluder.distance.c});
  return cuts;
}

/// Centres of the pixels of a rectangle of directions, those that lead along the outward direction.
void add_centres(const Direction& right, const Direction& up, const Direction& forward, const Window& w,
                 int columns, int rows, int axis, int sign, std::vector<Direction>& all) {
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Rational x = Rational(w.x0) +
                         (Rational(w.x1) - Rational(w.x0)) * Rational(2 * column + 1, 2 * columns),
                     y = Rational(w.y0) + (Rational(w.y1) - Rational(w.y0)) * Rational(2 * row + 1, 2 * rows);
      const Direction d = forward + x * right + y * up;
      if (sgn(at(d, axis)) == sign) all.push_back(d);
    }
}

/// Of the window, or of a hemicube: its front, and the halves of its four sides that lead outward.
std::vector<Direction> directions(const ViewCell& cell, int axis, bool upper, const PixelGrid& pixels) {
  std::vector<Direction> all;
  const int sign = upper ? 1 : -1;
  const auto exact = [](const Vec3d& v) { return Direction{v.x, v.y, v.z}; };
  if (cell.window) {
    const Frame& f = *cell.window;
    add_centres(exact(f.right), exact(f.up), exact(f.forward), f.window, pixels.width, pixels.height, axis,
                sign, all);
    return all;
  }
  const auto unit = [](int k, int length) {
    return Direction{k == 0 ? length : 0, k == 1 ? length : 0, k == 2 ? length : 0};
  };
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Direction out = unit(axis, sign);
  add_centres(unit(i, 1), unit(j, 1), out, {-1, 1, -1, 1}, pixels.width, pixels.height, axis, sign, all);
  for (const int s : {-1, 1}) {
    add_centres(out, unit(j, 1), unit(i, s), {0, 1, -1, 1}, (pixels.width + 1) / 2, pixels.height, axis, sign,
                all);
    add_centres(out, unit(i, 1), unit(j, s), {0, 1, -1, 1}, (pixels.width + 1) / 2, pixels.height, axis, sign,
                all);
  }
  return all;
}

}  // namespace

std::vector<Shown> offset_sample(const SceneArrays& scene, const ViewCell& cell, int axis, bool upper,
                                 const Direction& direction) {
  const Sample sample(cell, axis, upper, direction);
  std::vector<std::optional<Shape>> shapes;
  std::vector<std::array<Linear, 3>> in_plane;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    shapes.push_back(sample.shape(scene, t));
    if (const auto flat = sample.flat(scene, t)) in_plane.push_back(*flat);
  }
  std::vector<Shown> shown;
  for (std::size_t t = 0; t < shapes.size(); ++t) {
    std::vector<Polygon> left;
    if (shapes[t])
      if (Polygon p = sample.region(*shapes[t]); !p.empty()) left.push_back(std::move(p));
    for (std::size_t o = 0; o < shapes.size() && !left.empty(); ++o)
      if (o != t && shapes[o] && shapes[o]->occludes) left = less(left, before(*shapes[t], *shapes[o]));
    const bool any = !left.empty();
    for (const auto& sides : in_plane) left = less(left, {sides.begin(), sides.end()});
    shown.push_back(!any ? Shown::nothing : left.empty() ? Shown::on_occluders : Shown::proven);
  }
  return shown;
}

std::vector<Shown> offset_samples(const SceneArrays& scene, const ViewCell& cell, const PixelGrid& pixels) {
  std::vector<Shown> most(scene.triangles.size(), Shown::nothing);
  for (int axis = 0; axis < 3; ++axis) {
    // A flat cell is left through the two sides of its plane only.
    const auto flat = [&](int k) { return at(cell.lower, k) == at(cell.upper, k); };
    if (!flat(axis) && (flat(0) || flat(1) || flat(2))) continue;
    for (const bool upper : {false, true})
      for (const Direction& d : directions(cell, axis, upper, pixels)) {
        const std::vector<Shown> shown = offset_sample(scene, cell, axis, upper, d);
        for (std::size_t t = 0; t < most.size(); ++t) most[t] = std::max(most[t], shown[t]);
      }
  }
  return most;
}

}  // namespace provis::test
