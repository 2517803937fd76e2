#include "tests/support/cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace provis::test {

namespace {

using Rational = mpq_class;
using Rational3 = Vec3<mpq_class>;

Rational3 exact(const Vec3d& v) { return {v.x, v.y, v.z}; }
bool is_zero(const Rational3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Vec3d corner(const SceneArrays& s, std::size_t t, std::size_t k) { return s.vertices[s.triangles[t][k]]; }

Rational3 normal(const SceneArrays& s, std::size_t t) {
  const Rational3 a = exact(corner(s, t, 0)), b = exact(corner(s, t, 1)), c = exact(corner(s, t, 2));
  return cross(b - a, c - a);
}

/// -1 outside, 0 on the border, 1 in the relative interior, for a point of the triangle's plane.
int locate(const SceneArrays& s, std::size_t t, const Rational3& n, const Rational3& p) {
  int least = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational3 a = exact(corner(s, t, k)), b = exact(corner(s, t, (k + 1) % 3));
    least = std::min(least, sgn(dot(cross(b - a, p - a), n)));
  }
  return least;
}

double any_edge(Random& random) { return random.pick({0.125, 0.25, 0.5, 1.0, 1.0, 2.0}); }

}  // namespace

ViewCell any_cell(const Case& c, Random& random) {
  const double unit = [&] {
    double most = 0;
    for (const Vec3d& v : c.arrays.vertices)
      most = std::max({most, std::fabs(v.x - c.view.eye.x), std::fabs(v.y - c.view.eye.y)});
    // Scenes are drawn on a grid of side about 4 and then scaled by powers of two.
    return most > 0 && std::isfinite(most) ? std::exp2(std::ceil(std::log2(most)) - 2) : 1.0;
  }();
  Vec3d center = c.view.eye;
  switch (random.between(0, 3)) {
    case 0:
      break;
    case 1:
      if (!c.arrays.vertices.empty()) center = random.pick_from(c.arrays.vertices);
      break;
    case 2:
      center = center + (unit / 2) * random.lattice(3);
      break;
    default:
      center = center + unit * Vec3d{random.unit(), random.unit(), random.unit()};
  }
  Vec3d edges{unit * any_edge(random), unit * any_edge(random), unit * any_edge(random)};
  if (random.chance(15)) edges = (random.pick({0x1p-10, 0x1p-40})) * edges;
  if (random.chance(15)) edges.y = 0;
  if (random.chance(8)) edges.z = 0;
  ViewCell cell = cell_around(center, edges);
  // Now and then the box stands on its corner instead.
  if (random.chance(30)) cell = {center, center + edges, {}};
  if (random.chance(10)) {
    Frame f;
    do {
      f.right = random.lattice(2);
      f.up = random.lattice(2);
      f.forward = random.lattice(2);
    } while (dot(cross(f.right, f.up), f.forward) == 0);
    const double x = random.between(-2, 1), y = random.between(-2, 1);
    f.window = {x, x + 1.5, y, y + 1.25};
    cell.window = f;
  }
  return cell;
}

std::vector<PrimitiveId> hidden_among(const CellSet& upper, const std::vector<PrimitiveId>& seen) {
  std::vector<PrimitiveId> wrong;
  for (const PrimitiveId id : seen)
    if (upper.set.status[id] == Status::hidden) wrong.push_back(id);
  return wrong;
}

std::string describe(const Case& c, const ViewCell& cell) {
  const auto point = [](const Vec3d& p) { return fmt::format("{:a} {:a} {:a}", p.x, p.y, p.z); };
  std::string text = describe(c) + "\ncell " + point(cell.lower) + "  " + point(cell.upper);
  if (cell.window) {
    const Frame& f = *cell.window;
    text += "\nwindow " + point(f.right) + "  " + point(f.up) + "  " + point(f.forward) +
            fmt::format("  {} {} {} {}", f.window.x0, f.window.x1, f.window.y0, f.window.y1);
  }
  return text;
}

struct CellRays::Hit {
  PrimitiveId id;
  Rational distance;
  bool inside, occludes;
};

CellRays::Rational3 CellRays::any_viewpoint(Random& random) const {
  const Rational3 lo = exact(cell_.lower), hi = exact(cell_.upper);
  const auto share = [&] {
    // Mostly inside; sometimes in a face, an edge or a corner.
    constexpr int parts = 997;
    const int k = random.chance(15) ? (random.chance(50) ? 0 : parts) : random.between(0, parts);
    return Rational(k, parts);
  };
  const auto between = [&](const Rational& a, const Rational& b) -> Rational {
    return a + share() * (b - a);
  };
  return {between(lo.x, hi.x), between(lo.y, hi.y), between(lo.z, hi.z)};
}

CellRays::Rational3 CellRays::any_direction(const Rational3& viewpoint, Random& random) const {
  if (scene_.triangles.empty() || random.chance(10)) return exact(random.lattice(7));
  const std::size_t t = random.below(scene_.triangles.size());
  // Near the border as often as in the middle: that is where mistakes are.
  const auto weight = [&] {
    return Rational(random.pick({1, 1, 7, 50, 1000, 100000}) * random.between(1, 9));
  };
  const Rational u = weight(), v = weight(), w = weight();
  const Rational3 p =
      u * exact(corner(scene_, t, 0)) + v * exact(corner(scene_, t, 1)) + w * exact(corner(scene_, t, 2));
  return Rational(1 / (u + v + w)) * p - viewpoint;
}

bool CellRays::in_window(const Rational3& d) const {
  if (!cell_.window) return true;
  const Frame& f = *cell_.window;
  const Rational3 r = exact(f.right), u = exact(f.up), w = exact(f.forward);
  const auto det = [](const Rational3& a, const Rational3& b, const Rational3& c) -> Rational {
    return dot(cross(a, b), c);
  };
  const Rational whole = det(r, u, w), z = det(r, u, d) / whole;
  if (z <= 0) return false;
  const Rational x = det(d, u, w) / whole / z, y = det(r, d, w) / whole / z;
  // Strictly inside, so that neighbouring rays belong to the window too.
  return x > f.window.x0 && x < f.window.x1 && y > f.window.y0 && y < f.window.y1;
}

bool CellRays::on_occluder(const Rational3& v) const {
  for (std::size_t t = 0; t < scene_.triangles.size(); ++t) {
    if (scene_.triangle_flags[t] & see_through) continue;
    const Rational3 n = normal(scene_, t);
    if (is_zero(n) || dot(n, v - exact(corner(scene_, t, 0))) != 0) continue;
    if (locate(scene_, t, n, v) >= 0) return true;
  }
  return false;
}

std::vector<CellRays::Hit> CellRays::hits(const Rational3& v, const Rational3& d) const {
  std::vector<Hit> all;
  for (std::size_t t = 0; t < scene_.triangles.size(); ++t) {
    const Rational3 n = normal(scene_, t);
    const Rational fall = dot(n, d);
    if (fall == 0) continue;
    const Rational distance = dot(n, exact(corner(scene_, t, 0)) - v) / fall;
    if (distance <= 0) continue;
    const std::uint8_t flags = scene_.triangle_flags[t];
    if ((flags & single_sided) && fall > 0) continue;
    const int place = locate(scene_, t, n, v + distance * d);
    if (place < 0) continue;
    all.push_back({static_cast<PrimitiveId>(t), distance, place > 0, !(flags & see_through)});
  }
  return all;
}

std::vector<PrimitiveId> CellRays::seen(Random& random) const {
  const Rational3 v = any_viewpoint(random), d = any_direction(v, random);
  if (is_zero(d) || !in_window(d) || on_occluder(v)) return {};
  const std::vector<Hit> all = hits(v, d);
  std::vector<PrimitiveId> proven;
  for (const Hit& target : all) {
    if (!target.inside) continue;
    const Rational3 n = normal(scene_, target.id);
    const bool free = std::none_of(all.begin(), all.end(), [&](const Hit& h) {
      if (!h.occludes || h.distance > target.distance || h.id == target.id) return false;
      // In the target's plane iff all its corners are.
      for (std::size_t k = 0; k < 3; ++k)
        if (dot(n, exact(corner(scene_, h.id, k)) - exact(corner(scene_, target.id, 0))) != 0) return true;
      return false;
    });
    if (free) proven.push_back(target.id);
  }
  return proven;
}

}  // namespace provis::test
