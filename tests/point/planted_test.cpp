// Mistakes put into the oracle on purpose have to be noticed: the comparison is able to fail.

#include <catch2/catch.hpp>

#include "tests/point/answers.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"

namespace provis::test {
namespace {

/// How many of the first cases the engine and the mistaken oracle answer differently.
int noticed(Plant plant) {
  constexpr std::uint64_t cases = 400;
  int different = 0;
  for (std::uint64_t seed = 0; seed < cases; ++seed) {
    const Case c = generate(seed);
    different += engine_visible(c) != oracle_visible(c.arrays, c.view, plant);
  }
  return different;
}

}  // namespace

TEST_CASE("without a mistake nothing is noticed") { CHECK(noticed(Plant::none) == 0); }
TEST_CASE("a dropped occluder is noticed") { CHECK(noticed(Plant::drop_an_occluder) > 0); }
TEST_CASE("a flipped tie is noticed") { CHECK(noticed(Plant::flip_a_tie) > 0); }
TEST_CASE("an epsilon is noticed") { CHECK(noticed(Plant::use_an_epsilon) > 0); }

}  // namespace provis::test
