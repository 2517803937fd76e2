#pragma once
// How signs are computed, and the price paid for them.

#include <array>
#include <cstdint>
#include <string_view>

namespace provis {

/// The arithmetic by which an engine takes its branches.
enum class Arithmetic {
  doubles,  ///< plain float64, no error bound: fast, and sometimes wrong; for comparison only
  chain,    ///< structure, filter, interval, exact, in this order: the product
  mpfr,     ///< MPFR intervals of growing precision for every sign: certain and slow
  exact,    ///< exact dyadic rationals for every sign: certain and slow
};

/// The tier that decided a sign; mpfr belongs to Arithmetic::mpfr only.
enum class Tier { structure, filter, interval, mpfr, exact };
inline constexpr int tier_count = 5;

/// The predicates that are counted (predicates/README.md has their polynomials).
enum class Predicate {
  facing,              ///< which side of a triangle's plane the viewpoint lies on
  front,               ///< which side of the window's plane a point lies on (eye at infinity)
  turn,                ///< which side of a projected edge or border an input point or direction lies on
  turn_constructed,    ///< the same for the crossing of two lines
  nearer,              ///< which of two planes is met first along an input point or direction
  nearer_constructed,  ///< the same along the crossing of two lines
  coplanar,            ///< whether two triangles lie in one plane
  along,               ///< from which side a pixel's rays meet a triangle's plane
  motion,              ///< where an event can be: the signs of a function that is linear in time
  event_order,         ///< order of two events, or what is nearer at one
};
inline constexpr int predicate_count = 10;

std::string_view name(Arithmetic arithmetic);
std::string_view name(Tier tier);
std::string_view name(Predicate predicate);

/// How often each tier decided each predicate.
struct SignCounts {
  std::array<std::array<std::uint64_t, tier_count>, predicate_count> decided{};
  /// Signs that plain doubles took wrongly; counted only where they are checked (check_doubles.hpp).
  std::array<std::uint64_t, predicate_count> wrong{};

  std::uint64_t& at(Predicate p, Tier t) {
    return decided[static_cast<std::size_t>(p)][static_cast<std::size_t>(t)];
  }
  std::uint64_t at(Predicate p, Tier t) const {
    return decided[static_cast<std::size_t>(p)][static_cast<std::size_t>(t)];
  }
  std::uint64_t& wrong_of(Predicate p) { return wrong[static_cast<std::size_t>(p)]; }
  std::uint64_t wrong_of(Predicate p) const { return wrong[static_cast<std::size_t>(p)]; }
  SignCounts& operator+=(const SignCounts& other);
};

}  // namespace provis
