#include "src/offset/sight_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace provis::offset {
namespace {

/// Whether certainly all three have one sign.
bool one_sign(const std::array<Interval, 3>& x) {
  return std::min({x[0].inf(), x[1].inf(), x[2].inf()}) > 0 ||
         std::max({x[0].sup(), x[1].sup(), x[2].sup()}) < 0;
}

}  // namespace

SightLine::SightLine(const Point& from, const Point& to) : from_(from), to_(to) {
  const Point d = to - from;
  const auto size = [&](int axis) { return std::fabs(component(d, axis).inf() + component(d, axis).sup()); };
  for (const int axis : {0, 1})
    if (size(axis) > size(along_)) along_ = axis;
  length_ = component(d, along_);
  i_ = (along_ + 1) % 3;
  j_ = (along_ + 2) % 3;
  if (length_.sup() < 0) std::swap(i_, j_);
  known_ = length_.inf() > 0 || length_.sup() < 0;
  slope_i_ = component(d, i_);
  slope_j_ = component(d, j_);
}

/// Seen along the line, which then is the origin, corners have the coordinates d_k q_i - d_i q_k and
/// d_k q_j - d_j q_k, q leading from the line's start to the corner and k being the axis along which it is
/// longest: their cross products are those of det[p0 - from, p1 - from, d], times |d_k|.
std::optional<bool> SightLine::aims_at(const Facet& f) const {
  if (!known_) return std::nullopt;
  const Interval &start_i = component(from_, i_), &start_j = component(from_, j_),
                 &start = component(from_, along_);
  std::array<Interval, 3> ahead, x, y;
  for (std::size_t k = 0; k < 3; ++k) {
    ahead[k] = Interval(component(*f.p[k], along_)) - start;
    x[k] = length_ * (Interval(component(*f.p[k], i_)) - start_i) - slope_i_ * ahead[k];
  }
  if (one_sign(x)) return false;
  for (std::size_t k = 0; k < 3; ++k)
    y[k] = length_ * (Interval(component(*f.p[k], j_)) - start_j) - slope_j_ * ahead[k];
  if (one_sign(y)) return false;
  bool left = false, right = false, all_left = true;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const Interval turn = x[k] * y[l] - x[l] * y[k];
    left = left || turn.inf() > 0;
    right = right || turn.sup() < 0;
    all_left = all_left && turn.inf() > 0;
  }
  // A faced triangle is hit only where all three are positive.
  if (f.faced ? right : left && right) return false;
  return f.faced && all_left ? std::optional(true) : std::nullopt;
}

std::optional<bool> SightLine::crosses(const Facet& f) const {
  const std::optional<bool> aimed = aims_at(f);
  if (aimed == false || !f.faced) return aimed;
  const std::optional<Sign> side = beyond(f, to_);
  if (side == Sign::negative) return false;
  return side == Sign::positive ? aimed : std::nullopt;
}

}  // namespace provis::offset
