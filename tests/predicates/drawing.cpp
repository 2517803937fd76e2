#include "tests/predicates/drawing.hpp"

namespace provis::test {

Drawing::Drawing(NearFamily family, std::uint64_t seed)
    : input(make_input(family, seed)), reference(input.geometry), random_(~seed) {
  make_edges_and_borders();
  make_depth_lines();
  make_directions();
}

std::vector<Drawing::Pair> Drawing::pairs(int count) {
  std::vector<Pair> chosen;
  for (int k = 0; k < count; ++k) chosen.push_back({random_.pick_from(lines), random_.pick_from(directions)});
  return chosen;
}

/// Equal positions share an id, as they do after an engine's weld.
std::uint32_t Drawing::point_id(std::size_t index) const {
  for (std::size_t k = 0; k < index; ++k)
    if (input.points[k] == input.points[index]) return static_cast<std::uint32_t>(k);
  return static_cast<std::uint32_t>(index);
}

void Drawing::make_edges_and_borders() {
  for (int k = 0; k < 3; ++k) {
    Line& l = lines.emplace_back();
    const std::size_t a = random_.below(7), b = random_.below(7);
    l.first.p[0] = &input.points[a];
    l.first.p[1] = &input.points[b];
    l.points[0] = point_id(a);
    l.points[1] = point_id(b);
  }
  for (const LineKind kind : {LineKind::x_border, LineKind::y_border, LineKind::image}) {
    Line& l = lines.emplace_back();
    l.kind = kind;
    l.at = input.at[random_.below(2)];
    l.negated = kind != LineKind::image && random_.chance(50);
  }
}

/// Corners in the order in which at_eye > 0; false where a few draws only gave triangles that are edge-on.
bool Drawing::find_triangle(std::array<std::size_t, 3>& c) {
  for (int attempt = 0; attempt < 8; ++attempt) {
    for (std::size_t& k : c) k = random_.below(7);
    const auto& p = input.points;
    const Sign facing = reference.facing(p[c[0]], p[c[1]], p[c[2]]);
    if (facing == Sign::negative) std::swap(c[1], c[2]);
    if (facing != Sign::zero) return true;
  }
  return false;
}

void Drawing::make_depth_lines() {
  std::vector<std::array<std::size_t, 3>> triangles;
  for (std::array<std::size_t, 3> c; triangles.size() < 3 && find_triangle(c);) triangles.push_back(c);
  const auto corners = [&](std::size_t t) {
    const auto& [a, b, c] = triangles[t];
    return Corners{{&input.points[a], &input.points[b], &input.points[c]}};
  };
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t j = i + 1; j < triangles.size(); ++j) {
      Line& l = lines.emplace_back();
      l.kind = LineKind::depth;
      l.first = corners(i);
      l.second = corners(j);
      l.planes[0] = static_cast<std::uint32_t>(i);
      l.planes[1] = static_cast<std::uint32_t>(j);
      int shared = 0;
      for (const std::size_t a : triangles[i])
        for (const std::size_t b : triangles[j])
          if (shared < 2 && point_id(a) == point_id(b)) l.points[shared++] = point_id(a);
    }
  if (!input.geometry.at_infinity || triangles.empty()) return;
  Line& l = lines.emplace_back();
  l.kind = LineKind::front;
  l.first = corners(0);
}

void Drawing::make_directions() {
  for (int k = 0; k < 3; ++k) {
    Direction& d = directions.emplace_back();
    const std::size_t p = random_.below(7);
    d.kind = DirectionKind::point;
    d.point = &input.points[p];
    d.point_id = point_id(p);
    d.negated = random_.chance(20);
  }
  Direction& window = directions.emplace_back();
  window.kind = DirectionKind::window;
  window.numbers = {input.at[random_.below(2)], input.at[random_.below(2)], 0};
  Direction& given = directions.emplace_back();
  given.kind = DirectionKind::given;
  given.numbers = input.given;
  for (int k = 0; k < 5; ++k) {
    Direction& d = directions.emplace_back();
    d.kind = DirectionKind::crossing;
    d.lines[0] = &random_.pick_from(lines);
    d.lines[1] = &random_.pick_from(lines);
    d.negated = random_.chance(20);
  }
}

}  // namespace provis::test
