#include "tests/support/window_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace provis::test {

Line make_line(Integer3 coefficients) { return std::make_shared<const Shadowed>(std::move(coefficients)); }

bool overlap(const Box& a, const Box& b) {
  return a.x.lo < b.x.hi && b.x.lo < a.x.hi && a.y.lo < b.y.hi && b.y.lo < a.y.hi;
}

double overlap_area(const Box& a, const Box& b) {
  const double width = std::min(a.x.hi, b.x.hi) - std::max(a.x.lo, b.x.lo);
  const double height = std::min(a.y.hi, b.y.hi) - std::max(a.y.lo, b.y.lo);
  return std::max(width, 0.0) * std::max(height, 0.0);
}

WindowPolygon::Corner::Corner(Integer3 xyw)
    : at(sgn(xyw.z) < 0 ? -xyw : xyw),
      box{quotient_bounds(at.exact().x, at.exact().z), quotient_bounds(at.exact().y, at.exact().z)} {}

WindowPolygon::WindowPolygon(const Window& window) {
  CommonScale scale;
  for (const double border : {window.x0, window.x1, window.y0, window.y1}) scale.include(border);
  const Integer one = scale(1.0), zero = 0;
  const Line bottom = make_line({zero, one, -scale(window.y0)}),
             right = make_line({one, zero, -scale(window.x1)});
  const Line top = make_line({zero, one, -scale(window.y1)}),
             left = make_line({one, zero, -scale(window.x0)});
  sides_ = {{crossing(left, bottom), bottom},
            {crossing(bottom, right), right},
            {crossing(right, top), top},
            {crossing(top, left), left}};
  fit_box();
}

std::shared_ptr<const WindowPolygon::Corner> WindowPolygon::crossing(const Line& a, const Line& b) {
  return std::make_shared<const Corner>(cross(a->exact(), b->exact()));
}

WindowPolygon WindowPolygon::clipped(const Line& line, int side) const {
  const std::size_t n = sides_.size();
  std::vector<int> sign(n);
  for (std::size_t i = 0; i < n; ++i) sign[i] = side * sign_of_dot(*line, sides_[i].start->at);
  if (std::none_of(sign.begin(), sign.end(), [](int s) { return s > 0; })) return {};
  if (std::none_of(sign.begin(), sign.end(), [](int s) { return s < 0; })) return *this;

  WindowPolygon part;
  for (std::size_t i = 0; i < n; ++i) {
    const Side& along = sides_[i];
    const int next = sign[(i + 1) % n];
    if (sign[i] > 0 || (sign[i] == 0 && next > 0)) part.sides_.push_back(along);
    if (sign[i] == 0 && next < 0) part.sides_.push_back({along.start, line});
    if (sign[i] > 0 && next < 0) part.sides_.push_back({crossing(along.line, line), line});
    if (sign[i] < 0 && next > 0) part.sides_.push_back({crossing(along.line, line), along.line});
  }
  part.fit_box();
  return part;
}

std::vector<Integer3> WindowPolygon::corners() const {
  std::vector<Integer3> all;
  for (const Side& side : sides_) all.push_back(side.start->at.exact());
  return all;
}

// A mean of three corners with uneven weights lies inside, and hardly ever on a line that means something to
// the scene. It is rounded to 2^-bits, ever finer until it stays inside the triangle that these corners form:
// on the side of each edge on which the mean is.
Integer3 WindowPolygon::dyadic_inner_point() const {
  const Integer3 &a = sides_[0].start->at.exact(), &b = sides_[1].start->at.exact(),
                 &c = sides_[2].start->at.exact();
  const Integer in_a = 1000003 * b.z * c.z, in_b = 999983 * c.z * a.z, in_c = 1000033 * a.z * b.z;
  const Integer3 mean = in_a * a + in_b * b + in_c * c;
  const auto stays_inside = [&](const Integer3& p) {
    for (const Integer3& edge : {cross(a, b), cross(b, c), cross(c, a)}) {
      if (sgn(dot(edge, p)) != sgn(dot(edge, mean))) return false;
    }
    return true;
  };
  for (mp_bitcnt_t bits = 64;; bits *= 2) {
    const Integer x = (mean.x << bits) / mean.z, y = (mean.y << bits) / mean.z;
    const Integer3 rounded{x, y, Integer(1) << bits};
    if (stays_inside(rounded)) return rounded;
  }
}

double WindowPolygon::rounded_area() const {
  double doubled = 0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Box& a = sides_[i].start->box;
    const Box& b = sides_[(i + 1) % sides_.size()].start->box;
    doubled += a.x.lo * b.y.lo - a.y.lo * b.x.lo;
  }
  return std::abs(doubled) / 2;
}

void WindowPolygon::fit_box() {
  box_ = sides_.front().start->box;
  for (const Side& side : sides_) {
    const Box& b = side.start->box;
    box_.x = {std::min(box_.x.lo, b.x.lo), std::max(box_.x.hi, b.x.hi)};
    box_.y = {std::min(box_.y.lo, b.y.lo), std::max(box_.y.hi, b.y.hi)};
  }
}

}  // namespace provis::test
