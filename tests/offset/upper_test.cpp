// What the camera offset space proves hidden, by hand: walls, gaps, contact, sides.

#include <catch2/catch.hpp>

#include <algorithm>

#include "provis/cell.hpp"

namespace provis::test {
namespace {

const ViewCell cell{{-0.5, -0.5, 0}, {0.5, 0.5, 1}, {}};

/// Two triangles of a rectangle across z.
void add_wall(SceneArrays& s, const Vec3d& lo, const Vec3d& hi, std::uint8_t flags = 0) {
  const auto v = static_cast<std::uint32_t>(s.vertices.size());
  for (const Vec3d& p : {lo, Vec3d{hi.x, lo.y, hi.z}, hi, Vec3d{lo.x, hi.y, lo.z}}) s.vertices.push_back(p);
  s.triangles.push_back({v, v + 1, v + 2});
  s.triangles.push_back({v, v + 2, v + 3});
  s.triangle_flags.insert(s.triangle_flags.end(), 2, flags);
}

std::vector<PrimitiveId> hidden(const SceneArrays& s, const ViewCell& from = cell, int pixels = 4) {
  CellOptions options;
  options.method = CellMethod::cos;
  options.pixels = {pixels, pixels};
  return visible_from_cell(Scene(s), from, options).set.with(Status::hidden);
}

using Ids = std::vector<PrimitiveId>;

}  // namespace

TEST_CASE("a wall of two triangles hides what is behind all of it") {
  SceneArrays s;
  add_wall(s, {-9, -9, -1}, {9, 9, -1});
  add_wall(s, {-1, -1, -3}, {1, 1, -3});
  for (const int pixels : {1, 2, 3, 8}) CHECK(hidden(s, cell, pixels) == Ids{2, 3});
}

TEST_CASE("what is seen past the wall's edge from one edge of the cell only is not hidden") {
  // The line from (0.5, ., 1) through the wall's end (1, ., -1) meets z = -3 at x = 1.5; from the middle of
  // the lower face it would be x = 3.
  const auto behind_end = [](double x) {
    SceneArrays s;
    add_wall(s, {-9, -9, -1}, {1, 9, -1});
    add_wall(s, {1.25, -0.01, -3}, {x, 0.01, -3});
    return hidden(s);
  };
  for (const double x : {1.5 + 0x1p-40, 1.501, 1.6, 2.5}) {
    INFO(x);
    CHECK(behind_end(x).empty());
  }
  CHECK(behind_end(1.49) == Ids{2, 3});
}

TEST_CASE("what one corner of the cell alone sees is not hidden, whichever corner it is") {
  // A wall that leaves out one quadrant, x > 1 and y > 1, and behind it a little square that the corner
  // (1/2, 1/2, 1) sees, past the wall's own corner, up to x = y = 1.5 + a little. Then turned and mirrored.
  const ViewCell cube{{-0.5, -0.5, 0}, {0.5, 0.5, 1}, {}};
  for (const double end : {1.5 + 0x1p-10, 1.49})
    for (int turn = 0; turn < 3; ++turn)
      for (int signs = 0; signs < 8; ++signs) {
        const auto moved = [&](Vec3d p) {
          for (int k = 0; k < turn; ++k) p = {p.y, p.z, p.x};
          return Vec3d{signs & 1 ? -p.x : p.x, signs & 2 ? -p.y : p.y, signs & 4 ? -p.z : p.z};
        };
        SceneArrays s;
        add_wall(s, {-9, -9, -1}, {1, 1, -1});
        add_wall(s, {-9, 1, -1}, {1, 9, -1});
        add_wall(s, {1, -9, -1}, {9, 1, -1});
        add_wall(s, {1.25, 1.25, -3}, {end, end, -3});
        for (Vec3d& v : s.vertices) v = moved(v);
        const Vec3d a = moved(cube.lower), b = moved(cube.upper);
        const ViewCell from{{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                            {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)},
                            {}};
        INFO(end << ", turned " << turn << " times, signs " << signs);
        for (const int pixels : {1, 4}) CHECK(hidden(s, from, pixels) == (end < 1.5 ? Ids{6, 7} : Ids{}));
      }
}

TEST_CASE("a gap between two walls is no shared edge") {
  for (const double gap : {0.0, 0x1p-40, 0.5}) {
    SceneArrays s;
    add_wall(s, {-9, -9, -1}, {0, 9, -1});
    add_wall(s, {gap, -9, -1}, {9, 9, -1});
    add_wall(s, {-1, -1, -3}, {1, 1, -3});
    INFO(gap);
    CHECK(hidden(s) == (gap == 0 ? Ids{4, 5} : Ids{}));
  }
}

TEST_CASE("walls that overlap without sharing an edge hide together") {
  // However thin the strip is in which they overlap, and if one of them lies behind the other.
  for (const double overlap : {0x1p-50, 0x1p-40, 0.5})
    for (const double depth : {0.0, 0x1p-50, 0.5}) {
      SceneArrays s;
      add_wall(s, {-9, -9, -1 - depth}, {overlap + 2 * depth, 9, -1 - depth});
      add_wall(s, {0, -9, -1}, {9, 9, -1});
      add_wall(s, {-1, -1, -3}, {1, 1, -3});
      INFO(overlap << ' ' << depth);
      CHECK(hidden(s, cell, 3) == Ids{4, 5});
    }
}

TEST_CASE("a rounded T-junction hides where the edges overlap, and shows where they are apart") {
  // The left wall's long edge, and two right walls that meet at its middle but for a little; then all of it
  // sheared, so that no coordinate is a grid's.
  for (const double middle : {-0x1p-52, -0x1p-30, 0x1p-52, 0x1p-30})
    for (const double shear : {0.0, 0.1}) {
      SceneArrays s;
      s.vertices = {{0, -9, -1}, {0, 9, -1}, {-9, -9, -1}, {-9, 9, -1},
                    {9, -9, -1}, {9, 9, -1}, {9, 0, -1},   {middle, 0, -1}};
      s.triangles = {{0, 1, 2}, {2, 1, 3}, {0, 4, 7}, {4, 6, 7}, {7, 6, 5}, {7, 5, 1}};
      s.triangle_flags.assign(6, 0);
      add_wall(s, {-0.25, -1, -3}, {0.25, 1, -3});
      for (Vec3d& v : s.vertices) v.x += shear * v.y;
      INFO(middle << ' ' << shear);
      CHECK(hidden(s, cell, 3) == (s.vertices[7].x < 0 ? Ids{6, 7} : Ids{}));
    }
}

TEST_CASE("occluders that meet in one vertex hide together, though two of their edges stay open") {
  // Three quarters of a wall around (0, 0, -1), and a triangle that covers the fourth and reaches over one of
  // its neighbours; there it stands out towards the cell, or lies behind.
  for (const double z : {-0.5, -1.5}) {
    SceneArrays s;
    s.vertices = {{0, 0, -1},  {0, 9, -1},  {-9, 9, -1}, {-9, 0, -1}, {-9, -9, -1},
                  {0, -9, -1}, {9, -9, -1}, {9, 0, -1},  {-4, 9, z}};
    s.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 7}, {0, 7, 8}};
    s.triangle_flags.assign(7, 0);
    add_wall(s, {-0.25, -0.25, -3}, {0.25, 0.25, -3});
    INFO(z);
    CHECK(hidden(s, cell, 3) == Ids{7, 8});
  }
}

TEST_CASE("see-through walls and absent sides hide nothing") {
  for (const int flags : {0, int{see_through}, int{single_sided}}) {
    SceneArrays s;
    add_wall(s, {-9, -9, -1}, {9, 9, -1}, static_cast<std::uint8_t>(flags));
    add_wall(s, {-1, -1, -3}, {1, 1, -3});
    // Fronts look along +z, towards the cell.
    CHECK(hidden(s) == (flags == see_through ? Ids{} : Ids{2, 3}));
    for (Triangle& t : s.triangles) std::swap(t[0], t[1]);
    CHECK(hidden(s) == (flags == single_sided ? Ids{0, 1} : flags == 0 ? Ids{2, 3} : Ids{}));
  }
}

TEST_CASE("coincident and touching triangles are kept") {
  SceneArrays s;
  add_wall(s, {-9, -9, -1}, {9, 9, -1});
  add_wall(s, {-1, -1, -1}, {1, 1, -1});  // in the wall's plane
  CHECK(hidden(s).empty());
  // Stands on the wall with its near edge: behind it otherwise.
  s.vertices.push_back({-0.5, 0, -1});
  s.vertices.push_back({0.5, 0, -1});
  s.vertices.push_back({0, 0.1, -2});
  s.triangles.push_back({8, 9, 10});
  s.triangle_flags.push_back(0);
  CHECK(hidden(s) == Ids{4});
}

TEST_CASE("what pierces the wall is kept, and what is behind it is not") {
  SceneArrays s;
  add_wall(s, {-9, -9, -1}, {9, 9, -1});
  s.vertices.insert(s.vertices.end(), {{0.1, 0, -0.99}, {0.2, 0, -3}, {0, 0.3, -3}});
  s.triangles.push_back({4, 5, 6});
  s.triangle_flags.push_back(0);
  CHECK(hidden(s).empty());
  s.vertices[4].z = -1.01;
  CHECK(hidden(s) == Ids{2});
}

TEST_CASE("an occluder in the plane of a face, or behind it, hides nothing through that face") {
  SceneArrays s;
  add_wall(s, {-9, -9, 0.5}, {9, 9, 0.5});  // through the middle of the cell
  add_wall(s, {-1, -1, -3}, {1, 1, -3});
  CHECK(hidden(s).empty());
}

}  // namespace provis::test
