#include "src/offset/shaft.hpp"

#include <algorithm>

#include "predicates/certain_sign.hpp"

namespace provis::offset {
namespace {

/// Where the way from a to b has certainly crossed the border, b lying certainly outside: a share that is not
/// below the true one.
double share_beyond(const Interval& at_a, const Interval& at_b) {
  const Interval from(at_a.sup()), to(at_b.sup());
  const double s = (from / (from - to)).sup();
  return s < 1 ? s : 1;
}

/// What lies beyond at least one viewpoint of the face, in the normal's direction.
HalfSpace half_space(const Face& face, const Point& normal) {
  HalfSpace h{normal, dot(normal, numbers<Interval>(face.corners[0]))};
  for (const Vec3d& o : face.corners) {
    const Interval at = dot(normal, numbers<Interval>(o));
    h.least = Interval(std::min(h.least.inf(), at.inf()), std::min(h.least.sup(), at.sup()));
  }
  return h;
}

Corner cut(const Corner& a, const Corner& b, double share) {
  const Interval s(share);
  return {a.at + s * (b.at - a.at), -1};
}

}  // namespace

Polygon::Outside Polygon::outside(const HalfSpace& h) const {
  bool any_out = false, any_in = false;
  for (std::size_t k = 0; k < size; ++k) (height(h, corners[k].at).sup() < 0 ? any_out : any_in) = true;
  return !any_out ? Outside::none : any_in ? Outside::some : Outside::all;
}

Polygon::Outside Polygon::clip(const HalfSpace& h) {
  std::array<Interval, most> heights;
  bool any_out = false, any_in = false;
  for (std::size_t k = 0; k < size; ++k) {
    heights[k] = height(h, corners[k].at);
    (heights[k].sup() < 0 ? any_out : any_in) = true;
  }
  if (!any_out) return Outside::none;
  if (!any_in) {
    size = 0;
    return Outside::all;
  }
  std::array<Corner, 2 * most> kept;
  std::size_t n = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const std::size_t l = k + 1 == size ? 0 : k + 1;
    const bool out = heights[k].sup() < 0, next_out = heights[l].sup() < 0;
    if (!out) kept[n++] = corners[k];
    if (out == next_out) continue;
    // Nothing is cut where the inner corner may lie on the border: it stands for the crossing itself.
    const std::size_t in = out ? l : k, beyond = out ? k : l;
    if (heights[in].sup() > 0)
      kept[n++] = cut(corners[in], corners[beyond], share_beyond(heights[in], heights[beyond]));
  }
  if (n > most) return Outside::some;
  std::copy_n(kept.begin(), n, corners.begin());
  size = n < 3 ? 0 : static_cast<std::uint8_t>(n);
  return size == 0 ? Outside::all : Outside::some;
}

Polygon whole(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  Polygon p;
  p.corners[0] = {numbers<Interval>(a), 0};
  p.corners[1] = {numbers<Interval>(b), 1};
  p.corners[2] = {numbers<Interval>(c), 2};
  p.size = 3;
  return p;
}

Shafts::Shafts(const Frame& f) {
  const auto r = numbers<Interval>(f.right), u = numbers<Interval>(f.up), w = numbers<Interval>(f.forward);
  x_ = cross(u, w);
  y_ = cross(w, r);
  z_ = cross(r, u);
  const Sign orientation = certain_sign(
      [&]<class N>() { return dot(cross(numbers<N>(f.right), numbers<N>(f.up)), numbers<N>(f.forward)); });
  if (orientation == Sign::negative) {
    x_ = -x_;
    y_ = -y_;
    z_ = -z_;
  }
}

Shafts::Spaces Shafts::around(const Face& face, const Window& w) const {
  Point out{0, 0, 0};
  component(out, face.axis) = Interval(face.upper ? 1 : -1);
  const auto border = [&](const Point& along, double at) { return along - Interval(at) * z_; };
  return {half_space(face, border(x_, w.x0)),
          half_space(face, -border(x_, w.x1)),
          half_space(face, border(y_, w.y0)),
          half_space(face, -border(y_, w.y1)),
          half_space(face, out),
          half_space(face, z_)};
}

bool Shafts::holds(const Window& w, const Point& d) const {
  const Interval x = dot(x_, d), y = dot(y_, d), z = dot(z_, d);
  return z.inf() > 0 && (x - Interval(w.x0) * z).inf() >= 0 && (Interval(w.x1) * z - x).inf() >= 0 &&
         (y - Interval(w.y0) * z).inf() >= 0 && (Interval(w.y1) * z - y).inf() >= 0;
}

bool misses(const Vec3d& a, const Vec3d& b, const Shafts::Spaces& spaces) {
  const Point from = numbers<Interval>(a), to = numbers<Interval>(b);
  double first = 0, last = 1;
  for (const HalfSpace& h : spaces) {
    const Interval at_a = height(h, from), at_b = height(h, to);
    const bool out_a = at_a.sup() < 0, out_b = at_b.sup() < 0;
    if (out_a && out_b) return true;
    // Shares of the way at which the segment may leave or enter, never too little of it.
    if (out_b) last = std::min(last, share_beyond(at_a, at_b));
    if (out_a) first = std::max(first, (Interval(1) - Interval(share_beyond(at_b, at_a))).inf());
    if (first > last) return true;
  }
  return false;
}

}  // namespace provis::offset
