// The summary for people: about ten lines that hold the facts of the result.

#include "src/report/summary.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "src/report/names.hpp"
#include "tests/report/example_result.hpp"

using namespace provis;

TEST_CASE("a summary holds what the result says") {
  ResultFile result = example_result();
  result.set.witnesses.clear();
  result.set.subdivision.clear();
  const std::string text = summary(result);
  CHECK(std::count(text.begin(), text.end(), '\n') == 16);
  CHECK_THAT(text, Catch::Contains("left out   2 invalid primitives\n"));
  CHECK_THAT(text, Catch::Contains("5 triangles, 1 spheres"));
  CHECK_THAT(text, Catch::Contains(std::string(64, 'a')));
  CHECK_THAT(text, Catch::Contains("visible    3 (50 %)"));
  CHECK_THAT(text, Catch::Contains("hidden     2\n"));
  CHECK_THAT(text, Catch::Contains("undecided  1\n"));
  CHECK_THAT(text, Catch::Contains("bounds, answers R7, eye-on-primitive"));
  CHECK_THAT(text, Catch::Contains("0.125 s on 2 threads"));
  CHECK_THAT(text, Catch::Contains("exact 100 %"));
  CHECK_THAT(text, Catch::Contains("wrong      15 of these signs: nearer 15\n"));
}

TEST_CASE("a summary holds the counters of the methods that have some") {
  const std::string text = summary(example_result());
  CHECK_THAT(text, Catch::Contains("sampling   2.5 locations per pixel, at most 6\n"));
  CHECK_THAT(text, Catch::Contains("aggressive 75 % of the set, 93.75 % of the image\n"));
  CHECK_THAT(text, Catch::Contains("first      90 % of the set visible, 90 % of the rest decided\n"));
  CHECK_THAT(text, Catch::Contains("iterations 3, 2 decided by subtraction\n"));
  CHECK(sampling_text({}).empty());
}

TEST_CASE("nothing is said of what was left out where nothing was") {
  ResultFile result = example_result();
  result.header.left_out.clear();
  CHECK_THAT(summary(result), !Catch::Contains("left out"));
}

TEST_CASE("a query without signs has no shares to divide") {
  ResultFile result = example_result();
  result.set.stats = {};
  CHECK_THAT(summary(result), Catch::Contains("signs      0: structure 0 %"));
}

TEST_CASE("memory is told where it was measured") {
  QueryStats stats;
  CHECK(memory_text(stats).empty());
  stats.peak_bytes = 3 << 19;
  CHECK(memory_text(stats) == "memory     1.5 MiB at the peak, beyond the scene\n");
}

TEST_CASE("the sign table has a row per predicate and sums") {
  SignCounts signs;
  signs.at(Predicate::facing, Tier::filter) = 40;
  signs.at(Predicate::nearer, Tier::filter) = 2;
  const std::string table = sign_table(signs);
  CHECK(std::count(table.begin(), table.end(), '\n') == predicate_count + 2);
  CHECK(table.substr(table.rfind("all")).find("42") != std::string::npos);
}

TEST_CASE("every enumerator is found by its name, and nothing else is") {
  for (auto p : {Projection::pinhole, Projection::parallel, Projection::omni})
    CHECK(projection_named(name(p)) == p);
  for (auto s : {Sides::material, Sides::both}) CHECK(sides_named(name(s)) == s);
  for (auto o : {Opacity::material, Opacity::all}) CHECK(opacity_named(name(o)) == o);
  for (auto a : {Arithmetic::doubles, Arithmetic::chain, Arithmetic::mpfr, Arithmetic::exact}) {
    CHECK(arithmetic_named(name(a)) == a);
  }
  CHECK_FALSE(sides_named("front"));
  CHECK_FALSE(projection_named(""));
}
