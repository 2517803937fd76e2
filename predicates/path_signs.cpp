#include "predicates/path_signs.hpp"

#include "predicates/decide.hpp"

namespace provis {
namespace {

template <class N>
N height_above(const Vec3d& p, const Corners& t) {
  const Vec3<N> o = numbers<N>(*t.p[0]);
  return dot(cross(numbers<N>(*t.p[1]) - o, numbers<N>(*t.p[2]) - o), numbers<N>(p) - o);
}

}  // namespace

template <Arithmetic A>
template <class Formula>
Sign PathSigns<A>::decided(Predicate p, const Formula& formula) {
  const Decision decision = decide<A>(formula);
  count(p, decision.tier);
  if constexpr (A == Arithmetic::doubles)
    if (geometry_.checked && mistaken(decision.sign, formula)) count_wrong(p);
  return decision.sign;
}

template <Arithmetic A>
Sign PathSigns<A>::along(const Pixel& at, const Corners& t) {
  return decided(Predicate::along, [&]<class N>() { return sign_of(provis::along<N>(geometry_, at, t)); });
}

template <Arithmetic A>
Sign PathSigns<A>::at_zero(const Pixel& at, const Motion& m) {
  return decided(Predicate::motion,
                 [&]<class N>() { return sign_of(evaluate<N>(geometry_, at, m).at_zero); });
}

template <Arithmetic A>
Sign PathSigns<A>::slope(const Pixel& at, const Motion& m) {
  return decided(Predicate::motion, [&]<class N>() { return sign_of(evaluate<N>(geometry_, at, m).slope); });
}

template <Arithmetic A>
Sign PathSigns<A>::order(const Pixel& at, const Motion& first, const Motion& second) {
  return decided(Predicate::event_order, [&]<class N>() {
    return sign_of(event_order(evaluate<N>(geometry_, at, first), evaluate<N>(geometry_, at, second)));
  });
}

template <Arithmetic A>
Sign PathSigns<A>::height(const Vec3d& p, const Corners& t) {
  if constexpr (A == Arithmetic::chain)
    if (const auto s = sign_of(height_above<Ball>(p, t))) {
      count(Predicate::coplanar, Tier::filter);
      return *s;
    }
  return decided(Predicate::coplanar, [&]<class N>() { return sign_of(height_above<N>(p, t)); });
}

template class PathSigns<Arithmetic::doubles>;
template class PathSigns<Arithmetic::chain>;
template class PathSigns<Arithmetic::mpfr>;
template class PathSigns<Arithmetic::exact>;

}  // namespace provis
