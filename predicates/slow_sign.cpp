// The tiers behind the filter.

#include "predicates/decide.hpp"
#include "predicates/signs.hpp"

namespace provis {
namespace {

/// The sign of the functional's value at the ray. The arguments have to outlive it.
auto functional_at(const ViewGeometry& g, const Line& line, const Direction& direction) {
  return [&]<class N>() { return sign_of(dot(evaluate<N>(g, line), evaluate<N>(g, direction))); };
}

/// Zero if all three components are zero, positive if one certainly is not.
template <class N>
auto any_component(const Vec3<N>& v) {
  using Answer = decltype(sign_of(v.x));
  const Answer s[3] = {sign_of(v.x), sign_of(v.y), sign_of(v.z)};
  bool all_zero = true;
  for (const Answer& a : s) {
    if (a == Sign::negative || a == Sign::positive) return Answer(Sign::positive);
    if (a != Sign::zero) all_zero = false;
  }
  if constexpr (!std::is_same_v<Answer, Sign>)
    if (!all_zero) return Answer(std::nullopt);
  return Answer(Sign::zero);
}

}  // namespace

template <Arithmetic A>
template <class Formula>
Sign Signs<A>::decided(Predicate p, const Formula& formula) {
  const Decision decision = decide<A>(formula);
  count(p, decision.tier);
  if constexpr (A == Arithmetic::doubles)
    if (geometry_.checked && mistaken(decision.sign, formula)) ++counts_.wrong_of(p);
  return decision.sign;
}

template <Arithmetic A>
Sign Signs<A>::slow_side(const Line& line, const Direction& direction) {
  if constexpr (A == Arithmetic::chain)
    if (on_line_by_coordinates(geometry_, line, direction)) {
      count(predicate(line, direction), Tier::structure);
      return Sign::zero;
    }
  return decided(predicate(line, direction), functional_at(geometry_, line, direction));
}

template <Arithmetic A>
void Signs<A>::check(const Line& line, const Direction& direction, Sign taken) {
  if (mistaken(taken, functional_at(geometry_, line, direction)))
    ++counts_.wrong_of(predicate(line, direction));
}

template <Arithmetic A>
Sign Signs<A>::facing(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  if constexpr (A == Arithmetic::chain)
    if (const auto s = sign_of(triangle_plane<Ball>(geometry_, a, b, c).at_eye)) {
      count(Predicate::facing, Tier::filter);
      return *s;
    }
  return decided(Predicate::facing,
                 [&]<class N>() { return sign_of(triangle_plane<N>(geometry_, a, b, c).at_eye); });
}

template <Arithmetic A>
Sign Signs<A>::front(const Vec3d& p) {
  if constexpr (A == Arithmetic::chain)
    if (const auto s = sign_of(beyond_window<Ball>(geometry_, p))) {
      count(Predicate::front, Tier::filter);
      return *s;
    }
  return decided(Predicate::front, [&]<class N>() { return sign_of(beyond_window<N>(geometry_, p)); });
}

template <Arithmetic A>
bool Signs<A>::vanishes(const Line& line) {
  if constexpr (A == Arithmetic::chain)
    if (line.approx.size > line.approx.radius) {
      count(Predicate::coplanar, Tier::filter);
      return false;
    }
  if constexpr (A == Arithmetic::chain)
    if (line.kind == LineKind::depth && coplanar_by_coordinates(line.first, line.second)) {
      count(Predicate::coplanar, Tier::structure);
      return true;
    }
  return decided(Predicate::coplanar, [&]<class N>() {
           return any_component(provis::evaluate<N>(geometry_, line));
         }) == Sign::zero;
}

template class Signs<Arithmetic::doubles>;
template class Signs<Arithmetic::chain>;
template class Signs<Arithmetic::mpfr>;
template class Signs<Arithmetic::exact>;

}  // namespace provis
