#include "src/lod/plane_cells.hpp"

#include <algorithm>

#include "predicates/formulas.hpp"

namespace provis::lod {

PlaneCells::PlaneCells(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Point p = numbers<Rational>(a), q = numbers<Rational>(b), r = numbers<Rational>(c);
  const Point n = cross(q - p, r - p);
  int axis = 0;
  while (component(n, axis) == 0) ++axis;
  i_ = (axis + 1) % 3;
  j_ = (axis + 2) % 3;
  turn_ = sign_of(component(n, axis));
  whole_.corners = {spot(p), spot(q), spot(r)};
  for (std::size_t k = 0; k < 3; ++k) edges_[k] = line(whole_.corners[k], whole_.corners[(k + 1) % 3]);
}

PlaneCells::Spot PlaneCells::spot(const Point& p) const {
  return {p, enclosed(component(p, i_)), enclosed(component(p, j_))};
}

PlaneCells::Line PlaneCells::line(const Spot& from, const Spot& to) const {
  Line l;
  l.a = component(from.at, j_) - component(to.at, j_);
  l.b = component(to.at, i_) - component(from.at, i_);
  l.c = -(l.a * component(from.at, i_) + l.b * component(from.at, j_));
  l.around_a = enclosed(l.a);
  l.around_b = enclosed(l.b);
  l.around_c = enclosed(l.c);
  return l;
}

Rational PlaneCells::height(const Line& line, const Spot& p) const {
  return line.a * component(p.at, i_) + line.b * component(p.at, j_) + line.c;
}

Sign PlaneCells::side(const Line& line, const Spot& p) const {
  const auto s = sign_of(line.around_a * p.x + line.around_b * p.y + line.around_c);
  return s ? *s : sign_of(height(line, p));
}

/// Where the way from p to q, on different sides, crosses the line.
PlaneCells::Spot PlaneCells::crossing(const Spot& p, const Spot& q, const Line& line) const {
  const Rational f = height(line, p), share = f / (f - height(line, q));
  return spot(p.at + share * (q.at - p.at));
}

bool PlaneCells::divides(const Line& line, const Polygon& p) const {
  bool left = false, right = false;
  for (const Spot& corner : p) {
    const Sign s = side(line, corner);
    left = left || s == Sign::positive;
    right = right || s == Sign::negative;
  }
  return left && right;
}

/// Keeps what of the cut lies on one closed side; false if that is nothing, or on the line.
bool PlaneCells::clip(Cut& cut, const Line& line, Sign keep) const {
  const Sign from = side(line, cut.from) * keep, to = side(line, cut.to) * keep;
  if (from != Sign::positive && to != Sign::positive) return false;
  if (from == Sign::negative) cut.from = crossing(cut.from, cut.to, line);
  if (to == Sign::negative) cut.to = crossing(cut.from, cut.to, line);
  return true;
}

PlaneCells::Polygon PlaneCells::clip(const Polygon& p, const Line& line, Sign keep) const {
  Polygon kept;
  for (std::size_t k = 0; k < p.size(); ++k) {
    const Spot &a = p[k], &b = p[(k + 1) % p.size()];
    const Sign from = side(line, a) * keep, to = side(line, b) * keep;
    if (from != Sign::negative) kept.push_back(a);
    if (from * to == Sign::negative) kept.push_back(crossing(a, b, line));
  }
  return kept;
}

void PlaneCells::add_cut(Cut cut) {
  if (!divides(cut.line, whole_.corners)) return;
  for (const Line& edge : edges_)
    if (!clip(cut, edge, turn_)) return;
  whole_.cuts.push_back(std::move(cut));
}

void PlaneCells::add_segment(const Point& from, const Point& to) {
  const Spot f = spot(from), t = spot(to);
  add_cut({line(f, t), f, t});
}

void PlaneCells::add_contact(const Point& p) {
  Spot contact = spot(p);
  for (const Line& edge : edges_)
    if (side(edge, contact) != turn_) return;
  whole_.contacts.push_back(std::move(contact));
}

void PlaneCells::add_cover(const Cover& cover) {
  Laid laid{cover, {spot(cover.corners[0]), spot(cover.corners[1]), spot(cover.corners[2])}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    const Spot &from = laid.corners[k], &to = laid.corners[(k + 1) % 3];
    laid.edges[k] = line(from, to);
    add_cut({laid.edges[k], from, to});
  }
  covers_.push_back(std::move(laid));
}

PlaneCells::Cell PlaneCells::part(const Cell& cell, const Line& line, Sign keep) const {
  Cell half;
  half.corners = clip(cell.corners, line, keep);
  for (Cut cut : cell.cuts)
    if (clip(cut, line, keep) && divides(cut.line, half.corners)) half.cuts.push_back(std::move(cut));
  for (const Spot& contact : cell.contacts)
    if (side(line, contact) == keep) half.contacts.push_back(contact);
  for (const Laid* cover : cell.covers)
    if (std::any_of(cover->corners.begin(), cover->corners.end(),
                    [&](const Spot& p) { return side(line, p) == keep; }))
      half.covers.push_back(cover);
  return half;
}

bool PlaneCells::holds(const Laid& cover, const Spot& p) const {
  bool left = false, right = false;
  for (const Line& edge : cover.edges) {
    const Sign s = side(edge, p);
    left = left || s == Sign::positive;
    right = right || s == Sign::negative;
  }
  return !(left && right);
}

/// One of a sequence of points towards a corner: it has more of them than there are contacts.
Point PlaneCells::inner_point(const Cell& cell) {
  const Polygon& p = cell.corners;
  for (Rational share = 0.25;; share = share * Rational(0.5)) {
    const Point inner = lod::inner_point(p[0].at, p[1].at, p[2].at, share);
    if (std::none_of(cell.contacts.begin(), cell.contacts.end(),
                     [&](const Spot& contact) { return contact.at == inner; }))
      return inner;
  }
}

/// A cut lies in its closed cell. So it has inner points of the cell iff its line divides the cell.
bool PlaneCells::any(Cell cell, const Visit& visit) const {
  if (!cell.cuts.empty()) {
    const Line by = cell.cuts[cell.cuts.size() / 2].line;
    Cell left = part(cell, by, Sign::positive), right = part(cell, by, Sign::negative);
    cell = {};
    return any(std::move(left), visit) || any(std::move(right), visit);
  }
  const Point inner = inner_point(cell);
  const Spot there = spot(inner);
  std::vector<const Cover*> held;
  for (const Laid* cover : cell.covers)
    if (holds(*cover, there)) held.push_back(&cover->cover);
  return visit(inner, held);
}

bool PlaneCells::any(const Visit& visit) const {
  Cell whole = whole_;
  for (const Laid& cover : covers_) whole.covers.push_back(&cover);
  return any(std::move(whole), visit);
}

}  // namespace provis::lod
