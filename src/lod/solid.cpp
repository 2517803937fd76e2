#include "src/lod/solid.hpp"

#include <algorithm>

#include "predicates/certain_sign.hpp"
#include "predicates/formulas.hpp"
#include "predicates/plane_side.hpp"
#include "src/lod/coplanar.hpp"
#include "src/lod/plane_cells.hpp"

namespace provis::lod {
namespace {

template <class N>
Vec3<N> normal(const Corners& t) {
  return cross(numbers<N>(t[1]) - numbers<N>(t[0]), numbers<N>(t[2]) - numbers<N>(t[0]));
}

/// On which side of a triangle's plane a point lies.
Sign side(const Corners& t, const Vec3d& p) {
  if (p == t[0] || p == t[1] || p == t[2]) return Sign::zero;
  return plane_side(t[0], t[1], t[2], p);
}

struct Sides {
  std::array<Sign, 3> of;

  Sides(const Corners& plane, const Corners& t)
      : of{side(plane, t[0]), side(plane, t[1]), side(plane, t[2])} {}
  long count(Sign s) const { return std::count(of.begin(), of.end(), s); }
};

/// The chord, or the point, in which a triangle meets a plane that it does not lie in.
void add_meeting(const Corners& plane, const Corners& t, const Sides& sides, PlaneCells& cells) {
  std::vector<Point> ends;
  const Point n = normal<Rational>(plane), o = numbers<Rational>(plane[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t l = (k + 1) % 3;
    const Point a = numbers<Rational>(t[k]), b = numbers<Rational>(t[l]);
    if (sides.of[k] == Sign::zero) ends.push_back(a);
    if (sides.of[k] * sides.of[l] != Sign::negative) continue;
    const Rational f = dot(n, a - o), g = dot(n, b - o);
    ends.push_back(a + Rational(f / (f - g)) * (b - a));
  }
  if (ends.size() == 2) cells.add_segment(ends[0], ends[1]);
  // Beside a corner that touches t, winding numbers are t's; at the corner they are those of one of its
  // sectors.
  if (ends.size() == 1) cells.add_contact(ends[0]);
}

/// What of a chain meets a triangle.
class Section {
 public:
  explicit Section(const Corners& t) : t_(t), plane_(t) {}

  /// Returns whether m alone covers the triangle.
  bool add(const Corners& m, bool two_sided);

  /// As PlaneCells::any.
  bool any(const PlaneCells::Visit& visit) const;

 private:
  PlaneCells& cells() { return cells_ ? *cells_ : cells_.emplace(t_[0], t_[1], t_[2]); }

  const Corners& t_;
  Coplanar plane_;
  std::optional<PlaneCells> cells_;  ///< most triangles meet nothing, and need none
};

bool Section::add(const Corners& m, bool two_sided) {
  const Sides over(m, t_);
  if (over.count(Sign::zero) == 3) {
    if (plane_.apart(t_, m)) return false;
    const Sign facing = certain_sign([&]<class N>() { return dot(normal<N>(t_), normal<N>(m)); });
    cells().add_cover(
        {{numbers<Rational>(m[0]), numbers<Rational>(m[1]), numbers<Rational>(m[2])}, facing, two_sided});
    return plane_.covers(m, t_);
  }
  // The plane of m must cut t, or m meets nothing but its border.
  if (over.count(Sign::positive) == 0 || over.count(Sign::negative) == 0) return false;
  const Sides of_m(t_, m);
  if (of_m.count(Sign::positive) != 3 && of_m.count(Sign::negative) != 3) add_meeting(t_, m, of_m, cells());
  return false;
}

bool Section::any(const PlaneCells::Visit& visit) const {
  if (cells_) return cells_->any(visit);
  return visit(inner_point(numbers<Rational>(t_[0]), numbers<Rational>(t_[1]), numbers<Rational>(t_[2])), {});
}

/// Whether rays that come to a point of t from either side have met a side that is there at or before it.
bool fronts_before(const Chain& chain, const Corners& t, const Point& p,
                   const std::vector<const Cover*>& covers) {
  bool over = false, under = false;  // a side is there, for rays that come from where t's normal points to
  int facing = 0;
  for (const Cover* c : covers) {
    over = over || c->two_sided || c->facing == Sign::positive;
    under = under || c->two_sided || c->facing == Sign::negative;
    facing += static_cast<int>(c->facing);
  }
  if (over && under) return true;
  const Winding w = chain.winding(p);
  const Sign s = certain_sign([&]<class N>() { return dot(normal<N>(t), numbers<N>(w.direction)); });
  // Going through the plane against the normal enters what looks along it.
  const int above = s == Sign::positive ? w.number : w.number - facing, below = above + facing;
  return (over || above > 0) && (under || below > 0);
}

}  // namespace

std::optional<Point> outside(const Chain& chain, Inside inside, const Vec3d& a, const Vec3d& b,
                             const Vec3d& c) {
  const Scene& scene = chain.scene();
  const Corners t{a, b, c};
  const Box box = box_around(a, b, c);
  Section section(t);
  const bool covered =
      chain.tree().any([&](const Box& other) { return meet(box, other); },
                       [&](std::uint32_t m) {
                         const Corners corners{scene.corner(m, 0), scene.corner(m, 1), scene.corner(m, 2)};
                         if (!meet(box, box_around(corners[0], corners[1], corners[2]))) return false;
                         const bool alone = section.add(corners, !(scene.triangle_flags()[m] & single_sided));
                         return alone && inside == Inside::any_side;
                       });
  if (covered) return std::nullopt;
  std::optional<Point> found;
  section.any([&](const Point& p, const std::vector<const Cover*>& covers) {
    const bool in = inside == Inside::fronts ? fronts_before(chain, t, p, covers)
                                             : !covers.empty() || chain.winding(p).number != 0;
    if (!in) found = p;
    return !in;
  });
  return found;
}

}  // namespace provis::lod
