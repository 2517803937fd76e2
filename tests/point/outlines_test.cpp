// Outlines of cells: the same are touched as by looking at each, whatever was put in and taken out before.

#include <catch2/catch.hpp>

#include "src/point/cell_outlines.hpp"
#include "tests/support/random.hpp"

namespace provis::test {
namespace {

Window any_box(Random& random) {
  const auto side = [&] {
    const double a = static_cast<double>(random.below(9)), b = static_cast<double>(random.below(9));
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto [x0, x1] = side();
  const auto [y0, y1] = side();
  return {x0, x1, y0, y1};
}

struct Both {
  CellOutlines outlines;
  std::vector<CellOutline> plain;

  void compare(const Window& box, double nearest) const {
    std::vector<std::uint32_t> expected, got;
    double floor = HUGE_VAL;
    for (std::uint32_t k = 0; k < plain.size(); ++k) {
      floor = std::min(floor, plain[k].floor);
      if (!(nearest < plain[k].floor) && overlap(box, plain[k].box)) expected.push_back(k);
    }
    outlines.append_touched(box, nearest, got);
    REQUIRE(got == expected);
    REQUIRE(outlines.floor() == floor);
  }
};

}  // namespace

TEST_CASE("outlines of cells are touched where their boxes are and nothing of them is nearer") {
  Random random(20261130);
  constexpr Window everywhere{-HUGE_VAL, HUGE_VAL, -HUGE_VAL, HUGE_VAL};
  for (int round = 0; round < 200; ++round) {
    Both both;
    for (int step = 0; step < 40; ++step) {
      const CellOutline o{any_box(random),
                          random.below(4) == 0 ? -HUGE_VAL : static_cast<double>(random.below(5))};
      const std::size_t n = both.plain.size();
      switch (n == 0 ? 0 : random.below(4)) {
        case 1: {
          const std::size_t k = random.below(n);
          both.outlines.remove(k);
          both.plain[k] = both.plain.back();
          both.plain.pop_back();
          break;
        }
        case 2: {
          const std::size_t k = random.below(n);
          both.outlines.set(k, o);
          both.plain[k] = o;
          break;
        }
        default:
          both.outlines.push_back(o);
          both.plain.push_back(o);
      }
      both.compare(any_box(random), static_cast<double>(random.below(5)));
      both.compare(everywhere, HUGE_VAL);
    }
    both.outlines.clear();
    both.plain.clear();
    both.compare(everywhere, HUGE_VAL);
  }
}

}  // namespace provis::test
