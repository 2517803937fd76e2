// How often the filter gives up where nothing is degenerate: it may be careful, but not useless.

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>

#include "predicates/environment.hpp"
#include "predicates/signs.hpp"
#include "tests/predicates/near_degenerate.hpp"

namespace provis::test {
namespace {

/// Asks every predicate about lines and directions that have nothing in common.
class Questions {
 public:
  Questions(const Input& input, SignCounts& counts) : in_(input), signs_(in_.geometry, counts) {}

  void ask() {
    signs_.front(in_.points[6]);
    const Line e = edge(0, 1), f = edge(2, 3), h = edge(4, 5), x = border(LineKind::x_border, 0),
               y = border(LineKind::y_border, 1), image = border(LineKind::image, 0);
    const Direction point = through(6), window = at_window(), apex = meet(f, h), corner = meet(x, y),
                    rim = meet(x, h);
    for (const Line* l : {&e, &x, &y, &image}) signs_.side(*l, point);
    signs_.side(e, window);
    for (const Direction* d : {&apex, &corner, &rim}) signs_.side(e, *d);

    const Line d = depth({0, 1, 2}, {3, 4, 5}), other = depth({1, 3, 6}, {0, 4, 2});
    const Direction trace = meet(other, e), on_trace = meet(d, other);
    signs_.vanishes(d);
    for (const Direction* ray : {&point, &window, &apex, &corner, &rim, &trace}) signs_.side(d, *ray);
    signs_.side(edge(5, 6), on_trace);
  }

 private:
  const Vec3d& at(int k) const { return in_.points[static_cast<std::size_t>(k)]; }

  Line edge(int a, int b) {
    Line l;
    l.first.p[0] = &at(a);
    l.first.p[1] = &at(b);
    return with_shadow(l);
  }

  Line border(LineKind kind, std::size_t k) {
    Line l;
    l.kind = kind;
    l.at = in_.at[k] + 0.1;
    return with_shadow(l);
  }

  Line depth(const std::array<int, 3>& t, const std::array<int, 3>& u) {
    Line l;
    l.kind = LineKind::depth;
    l.first = corners(t);
    l.second = corners(u);
    return with_shadow(l);
  }

  Corners corners(const std::array<int, 3>& t) {
    const Vec3d &a = at(t[0]), &b = at(t[1]), &c = at(t[2]);
    return signs_.facing(a, b, c) == Sign::positive ? Corners{{&a, &b, &c}} : Corners{{&a, &c, &b}};
  }

  Direction through(int p) {
    Direction d;
    d.kind = DirectionKind::point;
    d.point = &at(p);
    return with_shadow(d);
  }

  Direction at_window() {
    Direction d;
    d.kind = DirectionKind::window;
    d.numbers = {in_.at[0], in_.at[1], 0};
    return with_shadow(d);
  }

  Direction meet(const Line& l, const Line& m) {
    Direction d;
    d.kind = DirectionKind::crossing;
    d.lines[0] = &l;
    d.lines[1] = &m;
    d.approx = prepare(cross(l.approx, m.approx));
    return d;
  }

  template <class T>
  T with_shadow(T item) {
    item.approx = signs_.shadow(item);
    return item;
  }

  const Input& in_;
  Signs<Arithmetic::chain> signs_;
};

std::uint64_t asked(const SignCounts& c, Predicate p) {
  std::uint64_t sum = 0;
  for (int t = 0; t < tier_count; ++t) sum += c.at(p, Tier(t));
  return sum;
}

}  // namespace

TEST_CASE("filter: decides at least 99.99 % of the signs of generic input, whatever the predicate") {
  const RoundUp guard;
  SignCounts counts;
  const std::uint64_t cases = std::max<std::uint64_t>(2000, case_count());
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Input in = make_input(NearFamily::generic, seed);
    Questions(in, counts).ask();
  }
  // Those of Signs; the filter of what happens along a segment is its engine's, and tests/segment has its
  // rate.
  for (int p = 0; p <= static_cast<int>(Predicate::coplanar); ++p) {
    const std::uint64_t all = asked(counts, Predicate(p)), filter = counts.at(Predicate(p), Tier::filter);
    CAPTURE(name(Predicate(p)), all, filter);
    CHECK(all >= cases);
    CHECK(10000 * (all - filter) <= all);
  }
}

}  // namespace provis::test
