// R9's special cases, by hand.

#include <catch2/catch.hpp>

#include "predicates/environment.hpp"
#include "provis/error.hpp"
#include "src/region/contact.hpp"

namespace provis::test {
namespace {

const ViewCell unit_box{{0, 0, 0}, {1, 1, 1}, {}};

Contact touch(const Vec3d& a, const Vec3d& b, const Vec3d& c, std::uint8_t flags = 0,
              const ViewCell& cell = unit_box) {
  SceneArrays s;
  s.vertices = {a, b, c};
  s.triangles = {{0, 1, 2}};
  s.triangle_flags = {flags};
  const RoundUp guard;
  return contact(Scene(s), 0, cell);
}

}  // namespace

TEST_CASE("a triangle that meets the open box is visible") {
  CHECK(touch({0.25, 0.25, 0.25}, {0.5, 0.25, 0.25}, {0.25, 0.5, 0.25}) == Contact::visible);
  CHECK(touch({-9, -9, 0.5}, {9, -9, 0.5}, {0, 9, 0.5}) == Contact::visible);
  // Only a corner reaches in, by the smallest number there is.
  CHECK(touch({0x1p-1074, 0.5, 0.5}, {-1, 0.5, 0.5}, {-1, 1, 0.5}) == Contact::visible);
  CHECK(touch({0, 0.5, 0.5}, {-1, 0.5, 0.5}, {-1, 1, 0.5}) == Contact::apart);
  // Past an edge of the box, near and through it.
  CHECK(touch({-1, 1, 0.5}, {1, -1, 0.5}, {0, 0, 9}) == Contact::apart);
  CHECK(touch({-1, 1.25, 0.5}, {1.25, -1, 0.5}, {0, 0, 9}) == Contact::visible);
}

TEST_CASE("a triangle in the plane of a face is visible where it overlaps the face") {
  CHECK(touch({0.25, 0.25, 0}, {0.5, 0.25, 0}, {0.25, 0.5, 0}) == Contact::visible);
  CHECK(touch({1, 0, 0}, {2, 0, 0}, {1, 1, 0}) == Contact::apart);
  CHECK(touch({2, 0, 0}, {0, 2, 0}, {2, 2, 0}) == Contact::apart);  // touches the corner (1, 1, 0)
  CHECK(touch({1.75, 0, 0}, {0, 1.75, 0}, {2, 2, 0}) == Contact::visible);
}

TEST_CASE("sides decide on a face and behind the cell") {
  const Vec3d a{0.25, 0.25, 0}, b{0.5, 0.25, 0}, c{0.25, 0.5, 0};  // the front looks along +z
  CHECK(touch(a, b, c, single_sided) == Contact::visible);
  CHECK(touch(a, c, b, single_sided) == Contact::hidden);
  CHECK(touch({0, 0, 5}, {1, 0, 5}, {0, 1, 5}, single_sided) == Contact::hidden);
  CHECK(touch({0, 0, 5}, {0, 1, 5}, {1, 0, 5}, single_sided) == Contact::apart);
  CHECK(touch({0, 0, 0.5}, {1, 0, 0.5}, {0, 1, 0.5}, single_sided) == Contact::visible);
}

TEST_CASE("zero area is never visible, and flat cells have no inside") {
  CHECK(touch({0.25, 0.5, 0.5}, {0.5, 0.5, 0.5}, {0.75, 0.5, 0.5}) == Contact::hidden);
  const ViewCell flat{{0, 0, 0}, {1, 1, 0}, {}};
  CHECK(touch({0.25, 0.25, 0}, {0.5, 0.25, 0}, {0.25, 0.5, 0}, 0, flat) == Contact::hidden);
  CHECK(touch({0.5, 0.5, -1}, {0.5, 0.75, 1}, {0.5, 0.25, 1}, 0, flat) == Contact::apart);
}

TEST_CASE("a window that looks the other way sees neither") {
  ViewCell cell = unit_box;
  cell.window = Frame{};  // along -z
  const Vec3d a{0.25, 0.25, 0}, b{0.5, 0.25, 0}, c{0.25, 0.5, 0};
  CHECK(touch(a, b, c, single_sided, cell) == Contact::visible);
  const Vec3d up{0, 0, 1};
  CHECK(touch(a + up, b + up, c + up, 0, cell) != Contact::visible);
  // In the middle, from the front only: which looks along +z.
  const Vec3d half{0, 0, 0.5};
  CHECK(touch(a + half, b + half, c + half, single_sided, cell) == Contact::visible);
  CHECK(touch(a + half, c + half, b + half, single_sided, cell) != Contact::visible);
}

TEST_CASE("cells that make no sense are refused") {
  CHECK_THROWS_AS(check(ViewCell{{1, 0, 0}, {0, 1, 1}, {}}), Error);
  CHECK_THROWS_AS(check(ViewCell{{0, 0, 0}, {1, HUGE_VAL, 1}, {}}), Error);
  ViewCell empty_window = unit_box;
  empty_window.window = Frame{};
  empty_window.window->window = {0, 0, 0, 1};
  CHECK_THROWS_AS(check(empty_window), Error);
  CHECK_NOTHROW(check(ViewCell{{0, 0, 0}, {0, 0, 0}, {}}));
}

}  // namespace provis::test
