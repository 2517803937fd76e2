#pragma once
// Lines and corners of a leaf as float64 numbers with bounds: most signs need no more of them.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "src/point/cell.hpp"
#include "src/point/window_function.hpp"

namespace provis {

/// Bit 0: the opposite of the line; the rest is its index.
using LeafSide = std::uint32_t;

/// Both points, in either order, that are known to lie on a line; no_ends where there are no two.
using LineEnds = std::uint64_t;
inline constexpr LineEnds no_ends = ~LineEnds{0};

/// A line.
struct LeafBand {
  WindowFunction function;
  double slope = 0;         ///< |a| + |b|
  double bound = HUGE_VAL;  ///< three errors: of two evaluations, and of itself (ERRORS.md, 6)
  std::uint32_t points[2] = {no_id, no_id};  ///< input points known to lie on it
  LineEnds ends = no_ends;                   ///< both of them
  LineKind kind = LineKind::edge;
  std::uint32_t facet = 0;  ///< borders: which
  std::uint32_t other = 0;  ///< edge: which; depth: positive where `facet` is nearer than this one

  LeafBand() = default;
  explicit LeafBand(const WindowFunction& f)
      : function(f), slope(std::fabs(f.a) + std::fabs(f.b)), bound(3 * f.error) {}

  void hold(std::uint32_t a, std::uint32_t b) {
    points[0] = a;
    points[1] = b;
    if (b != no_id) ends = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
  }
};

/// What is known of the sign of an edge at a corner.
enum class CornerMark : std::int8_t { negative = -1, zero, positive, open, unasked };

inline CornerMark mark_of(Sign s) { return static_cast<CornerMark>(s); }
/// Requires: neither open nor unasked
inline Sign sign_of(CornerMark m) { return static_cast<Sign>(m); }

/// Where two lines cross.
struct LeafCorner {
  double x = 0, y = 0, error = HUGE_VAL;
  LineEnds ends[2] = {no_ends, no_ends};  ///< of both lines
  LeafSide sides[2] = {0, 0};             ///< both lines, in the order around the piece
  std::uint32_t point = no_id;            ///< input point that it is known to be
  std::uint32_t direction = no_id;        ///< its definition, where one was needed
  std::uint32_t asked_by = 0;             ///< the facet whose edges the marks speak of, by order of insertion
  std::array<CornerMark, 3> marks{CornerMark::unasked, CornerMark::unasked, CornerMark::unasked};
};

/// Where float64 can tell; plain doubles always can, but for what is not known at all.
template <Arithmetic A>
std::optional<Sign> quick_sign(const LeafBand& f, const LeafCorner& c) {
  const double value = f.function.at(c.x, c.y);
  // Where the corner is off, the value is by no more than the slope (ERRORS.md, 6).
  const double bound = (f.bound + f.slope * c.error) * (1 + 0x1p-20);
  if constexpr (A == Arithmetic::doubles)
    return bound < HUGE_VAL ? std::optional(sign_of(value)) : std::nullopt;
  if (value > bound) return Sign::positive;
  if (value < -bound) return Sign::negative;
  return std::nullopt;
}

/// Whether the line, of this index, goes through the corner by what is known of both.
inline bool known_zero(const LeafBand& band, std::uint32_t index, const LeafCorner& c) {
  return (c.point != no_id && (c.point == band.points[0] || c.point == band.points[1])) ||
         c.sides[0] >> 1 == index || c.sides[1] >> 1 == index ||
         (band.ends != no_ends && (band.ends == c.ends[0] || band.ends == c.ends[1]));
}

/// Where two lines cross inside a window (ERRORS.md, 6); anywhere in it, with no bound, where float64 cannot
/// tell.
inline void place(LeafCorner& c, const WindowFunction& f, const WindowFunction& g, const Window& w) {
  const double determinant = f.a * g.b - g.a * f.b;
  c.x = std::clamp((f.b * g.c - g.b * f.c) / determinant, w.x0, w.x1);
  c.y = std::clamp((g.a * f.c - f.a * g.c) / determinant, w.y0, w.y1);
  const double off_f = std::fabs(f.at(c.x, c.y)) + 2 * f.error,
               off_g = std::fabs(g.at(c.x, c.y)) + 2 * g.error;
  const double least =
      std::fabs(determinant) - 8 * unit_roundoff * (std::fabs(f.a * g.b) + std::fabs(g.a * f.b));
  const double reach =
      std::max(std::fabs(f.a), std::fabs(f.b)) * off_g + std::max(std::fabs(g.a), std::fabs(g.b)) * off_f;
  const double error = reach / least * (1 + 0x1p-20) + underflow_bound;
  if (least > 0x1p-900 && error < size_bound) {
    c.error = error;
    return;
  }
  c.x = w.x0;
  c.y = w.y0;
}

}  // namespace provis
