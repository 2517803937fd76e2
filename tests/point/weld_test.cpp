// Equal positions, equal ids.

#include <catch2/catch.hpp>

#include "src/point/weld.hpp"

namespace provis {

TEST_CASE("ids are dense, in order of first appearance, and equal for equal positions") {
  const Vec3d a{1, 2, 3}, b{1, 2, 4}, again{1, 2, 3};
  Weld weld(1);
  CHECK(weld.id(&a) == 0);
  CHECK(weld.id(&b) == 1);
  CHECK(weld.id(&again) == 0);
  CHECK(weld.positions() == std::vector<const Vec3d*>{&a, &b});
}

TEST_CASE("both zeros are one position, and one ulp makes another") {
  const Vec3d plus{0.0, 0, 1}, minus{-0.0, 0, 1}, near{5e-324, 0, 1};
  Weld weld(1);
  CHECK(weld.id(&plus) == weld.id(&minus));
  CHECK(weld.id(&near) != weld.id(&plus));
}

TEST_CASE("a table that was expected to stay small grows") {
  std::vector<Vec3d> grid;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j)
      for (int k = 0; k < 20; ++k) grid.push_back({double(i), double(j), double(k)});
  Weld weld(1);
  for (std::uint32_t p = 0; p < grid.size(); ++p) REQUIRE(weld.id(&grid[p]) == p);
  for (std::uint32_t p = 0; p < grid.size(); ++p) REQUIRE(weld.id(&grid[p]) == p);
}

}  // namespace provis
