// The oracle on scenes whose answers follow by reasoning. The eye looks along -z from the origin unless said.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/case.hpp"
#include "tests/support/mesh_builder.hpp"
#include "tests/support/oracle.hpp"

namespace provis::test {

namespace {

/// A scene under construction and the standard view.
struct Stage {
  Random random{1};
  MeshBuilder mesh{random, false};
  PointView view;

  Stage() { view.frames = {Frame{}}; }

  PrimitiveId add(const Vec3d& a, const Vec3d& b, const Vec3d& c, int flags = 0) {
    mesh.triangle(a, b, c);
    mesh.arrays().triangle_flags.back() = static_cast<std::uint8_t>(flags);
    return static_cast<PrimitiveId>(mesh.size() - 1);
  }

  /// A triangle facing the eye at depth z whose corners are seen in the same places at every depth.
  PrimitiveId shade(double z, int flags = 0) { return add({-z, -z, -z}, {z, -z, -z}, {0, z, -z}, flags); }

  std::vector<PrimitiveId> visible(Plant plant = Plant::none) const {
    const std::vector<bool> answer = oracle_visible(mesh.arrays(), view, plant);
    std::vector<PrimitiveId> ids;
    for (PrimitiveId t = 0; t < answer.size(); ++t) {
      if (answer[t]) ids.push_back(t);
    }
    return ids;
  }
};

using Ids = std::vector<PrimitiveId>;

}  // namespace

TEST_CASE("a nearer triangle hides one whose outline it covers exactly") {
  Stage s;
  s.shade(4);
  s.shade(2);
  CHECK(s.visible() == Ids{1});
}

TEST_CASE("half of a cover hides half") {
  Stage s;
  s.shade(4);
  s.add({-2, -2, -2}, {0, -2, -2}, {0, 2, -2});
  CHECK(s.visible() == Ids{0, 1});
  s.add({0, -2, -2}, {2, -2, -2}, {0, 2, -2});  // the other half: the seam between them is no leak
  CHECK(s.visible() == Ids{1, 2});
}

TEST_CASE("a seam one ulp wide is a leak") {
  Stage s;
  s.shade(4);
  s.add({-2, -2, -2}, {0, -2, -2}, {0, 2, -2});
  s.add({0x1p-1074, -2, -2}, {2, -2, -2}, {0, 2, -2});
  CHECK(s.visible() == Ids{0, 1, 2});
  CHECK(s.visible(Plant::use_an_epsilon) == Ids{1, 2});
}

TEST_CASE("coincident triangles are all visible") {
  Stage s;
  s.shade(2);
  s.shade(2);
  s.shade(4);
  CHECK(s.visible() == Ids{0, 1});
  CHECK(s.visible(Plant::flip_a_tie).empty());
}

TEST_CASE("coplanar triangles that overlap are both visible") {
  Stage s;
  s.add({-1, -1, -2}, {1, -1, -2}, {0, 1, -2});
  s.add({-1, 0, -2}, {1, 0, -2}, {0, -1, -2});
  CHECK(s.visible() == Ids{0, 1});
}

TEST_CASE("a see-through triangle is seen and hides nothing") {
  Stage s;
  s.shade(2, see_through);
  s.shade(4);
  s.shade(8, see_through);
  CHECK(s.visible() == Ids{0, 1});
}

TEST_CASE("a single-sided triangle seen from behind is neither seen nor hides") {
  Stage s;
  s.shade(4);
  s.add({2, -2, -2}, {-2, -2, -2}, {0, 2, -2}, single_sided);
  CHECK(s.visible() == Ids{0});
  s.add({-2, -2, -2}, {2, -2, -2}, {0, 2, -2}, single_sided);
  CHECK(s.visible() == Ids{2});
}

TEST_CASE("a triangle of zero area is neither seen nor hides") {
  Stage s;
  s.add({-1, 0, -2}, {1, 0, -2}, {0, 0, -2});
  s.add({0, 0, -2}, {0, 0, -2}, {0, 1, -2});
  s.shade(4);
  CHECK(s.visible() == Ids{2});
}

TEST_CASE("a triangle whose plane holds the eye is neither seen nor hides") {
  Stage s;
  s.add({0, -1, -1}, {0, 1, -1}, {0, 0, -3});
  s.add({-1, -1, 0}, {1, -1, 0}, {0, 2, 0});  // the eye lies on it
  s.shade(4);
  CHECK(s.visible() == Ids{2});
}

TEST_CASE("distances whose inverse is beyond float64 are told apart") {
  Stage s;
  s.shade(0x1p-1073);
  s.shade(0x1p-1074);
  CHECK(s.visible() == Ids{1});
}

TEST_CASE("what lies behind the eye is not seen, what crosses its plane is") {
  Stage s;
  s.add({-1, -1, 2}, {1, -1, 2}, {0, 1, 2});
  s.add({-9, -1, 5}, {9, -1, 5}, {0, -1, -5});
  CHECK(s.visible() == Ids{1});
}

TEST_CASE("three bars that overlap in a circle are all visible") {
  Stage s;
  s.add({-2, -0.5, -3}, {2, -0.5, -4}, {2, -1, -4});
  s.add({1, -2, -3}, {0, 2, -4}, {0.5, 2, -4});
  s.add({1, 1, -3}, {-2, -1, -4}, {-2, -0.5, -4});
  CHECK(s.visible() == Ids{0, 1, 2});
}

TEST_CASE("two triangles through each other are both visible") {
  Stage s;
  s.add({-1, -1, -2}, {-1, 1, -2}, {1, 0, -4});
  s.add({1, -1, -2}, {1, 1, -2}, {-1, 0, -4});
  CHECK(s.visible() == Ids{0, 1});
}

TEST_CASE("a box on a floor hides its base and its far sides") {
  Stage s;
  s.view.eye = {0, 3, 5};
  s.view.frames[0].forward = {0, -0.5, -1};
  s.mesh.parallelogram({-4, 0, 4}, {8, 0, 0}, {0, 0, -8});  // 0, 1
  s.mesh.box({-1, 0, -1}, {1, 1, 1});  // -x 2, 3; +x 4, 5; -y 6, 7; +y 8, 9; -z 10, 11; +z 12, 13
  CHECK(s.visible() == Ids{0, 1, 8, 9, 12, 13});
}

TEST_CASE("from inside a closed mesh all of it is seen and nothing outside") {
  Stage s;
  s.view.projection = Projection::omni;
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  s.view.frames = {{y, z, x, {}},  {y, z, -x, {}}, {z, x, y, {}},
                   {z, x, -y, {}}, {x, y, z, {}},  {x, y, -z, {}}};
  s.mesh.box({-1, -1, -1}, {1, 1, 1});
  s.mesh.box({1, -1, -1}, {3, 1, 1});  // face to face: its -x face coincides with the first box's +x face
  Ids expected;
  for (PrimitiveId t = 0; t < 12; ++t) expected.push_back(t);
  expected.push_back(12);
  expected.push_back(13);
  CHECK(s.visible() == expected);
}

TEST_CASE("what only touches the window's border is not seen") {
  Stage s;
  s.view.frames[0].window = {-0.5, 0.5, -0.5, 0.5};
  s.add({1, -1, -2}, {3, -1, -2}, {1, 1, -2});  // its left edge is seen at x = 0.5
  CHECK(s.visible().empty());
  s.add({std::nextafter(1.0, 0.0), -1, -2}, {3, -1, -2}, {1, 1, -2});
  CHECK(s.visible() == Ids{1});
}

TEST_CASE("a parallel view begins at the window's plane") {
  Stage s;
  s.view.projection = Projection::parallel;
  s.view.frames[0].window = {-4, 4, -4, 4};
  s.add({-1, -1, 1}, {1, -1, 1}, {0, 1, 1});     // behind the plane
  s.add({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});     // in it: distance 0 is no hit
  s.add({-1, -1, 1}, {1, -1, 1}, {0, 1, -1});    // through it: the part ahead is seen
  s.add({-1, -1, -5}, {1, -1, -5}, {0, 1, -5});  // seen beside that part
  s.add({0, -1, -1}, {0, 1, -1}, {0, 0, -3});    // edge-on
  CHECK(s.visible() == Ids{2, 3});
}

TEST_CASE("frame vectors of any kind are taken as they are") {
  Stage s;
  s.view.frames[0] = {{0, 3, 1}, {-2, 1, 0}, {1, 1, -4}, {-8, 8, -8, 8}};
  s.shade(4);
  s.shade(2);
  s.add({1, 1, -8}, {9, 1, -8}, {1, 9, -8});
  CHECK(s.visible() == Ids{1, 2});
}

TEST_CASE("a forgotten occluder shows") {
  Stage s;
  s.shade(4);
  s.shade(2);
  CHECK(s.visible(Plant::drop_an_occluder) == Ids{0, 1});
}

}  // namespace provis::test
