#pragma once
// The chain: structure, filter, interval, exact. Engines ask here and nowhere else.

#include <optional>

#include "predicates/line.hpp"
#include "predicates/view_geometry.hpp"
#include "provis/arithmetic.hpp"

namespace provis {

/// The number in which an engine keeps its float64 shadows under a policy.
template <Arithmetic A>
struct HotNumber {
  using type = Ball;
};
template <>
struct HotNumber<Arithmetic::doubles> {
  using type = double;
};

/// Signs under one arithmetic policy, for one view, counted. One object per task; a RoundUp guard must be
/// alive on the thread (for Arithmetic::doubles a RoundNearest guard).
///
/// Guarantee:  exact for every policy but Arithmetic::doubles, which takes the sign of the rounded value;
///             where the geometry says `checked`, it still does, and counts in SignCounts::wrong how often
///             that is not the exact sign
template <Arithmetic A>
class Signs {
 public:
  using Hot = typename HotNumber<A>::type;

  Signs(const ViewGeometry& geometry, SignCounts& counts) : geometry_(geometry), counts_(counts) {}

  const ViewGeometry& geometry() const { return geometry_; }

  /// Which side of the line the direction lies on.
  Sign side(const Line& line, const Direction& direction) {
    if (on_line_by_structure(line, direction)) {
      count(predicate(line, direction), Tier::structure);
      return Sign::zero;
    }
    if constexpr (A == Arithmetic::chain || A == Arithmetic::doubles)
      if (const auto s = filtered(line, direction)) return *s;
    return slow_side(line, direction);
  }

  /// The same where an answer is cheap; nullopt otherwise. The slow policies always answer.
  std::optional<Sign> quick_side(const Line& line, const Direction& direction) {
    if constexpr (A == Arithmetic::chain || A == Arithmetic::doubles) return filtered(line, direction);
    return side(line, direction);
  }

  /// The sign of at_eye of the triangle's plane: negative if it is seen from the front, zero if edge-on.
  Sign facing(const Vec3d& a, const Vec3d& b, const Vec3d& c);

  /// Positive if the point lies beyond the window's plane (eye at infinity).
  Sign front(const Vec3d& p);

  /// Whether a depth line is zero everywhere: both triangles lie in one plane.
  bool vanishes(const Line& depth_line);

  /// Counts a sign that an engine took from a function of its own with a certain bound.
  void count(Predicate p, Tier t) { ++counts_.at(p, t); }

  /// ViewGeometry::checked: counts the sign as wrong if the exact one is another.
  [[gnu::cold]] void check(const Line& line, const Direction& direction, Sign taken);

  /// The functional or ray in hot numbers.
  Approx shadow(const Line& line) const { return approximate(evaluate<Hot>(geometry_, line)); }
  ApproxDirection shadow(const Direction& direction) const {
    return prepare(approximate(evaluate<Hot>(geometry_, direction)));
  }

 private:
  static Predicate predicate(const Line& line, const Direction& direction) {
    const bool depth = line.kind == LineKind::depth || line.kind == LineKind::front;
    if (direction.kind == DirectionKind::crossing)
      return depth ? Predicate::nearer_constructed : Predicate::turn_constructed;
    return depth ? Predicate::nearer : Predicate::turn;
  }

  std::optional<Sign> filtered(const Line& line, const Direction& direction) {
    const FilteredValue f = provis::evaluate(line.approx, direction.approx);
    if constexpr (A == Arithmetic::doubles) {
      count(predicate(line, direction), Tier::filter);
      const Sign s = sign_of(f.value);
      if (geometry_.checked) [[unlikely]]
        check(line, direction, s);
      return s;
    }
    if (f.value > f.bound) {
      count(predicate(line, direction), Tier::filter);
      return Sign::positive;
    }
    if (f.value < -f.bound) {
      count(predicate(line, direction), Tier::filter);
      return Sign::negative;
    }
    return std::nullopt;
  }

  Sign slow_side(const Line& line, const Direction& direction);
  template <class Formula>
  Sign decided(Predicate p, const Formula& formula);
  const ViewGeometry& geometry_;
  SignCounts& counts_;
};

extern template class Signs<Arithmetic::doubles>;
extern template class Signs<Arithmetic::chain>;
extern template class Signs<Arithmetic::mpfr>;
extern template class Signs<Arithmetic::exact>;

}  // namespace provis
