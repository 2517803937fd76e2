// The catalogue of hard cases: every policy and every oracle gives the set that follows by reasoning.

#include <catch2/catch.hpp>

#include <gmpxx.h>

#include <algorithm>
#include <fstream>
#include <sstream>

#include "provis/witness.hpp"
#include "tests/point/answers.hpp"
#include "tests/point/hard_case.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/oracle.hpp"
#include "tests/support/ray_check.hpp"

namespace provis::test {
namespace {

const std::filesystem::path folder = PROVIS_SOURCE_DIR "/data/hard";

const std::vector<HardCase>& catalogue() {
  static const std::vector<HardCase> cases = load_hard_cases(folder);
  return cases;
}

/// A row of the README's table is one line, and its columns are set off by bars.
bool fits_a_row(const std::string& text) {
  return !text.empty() && text.find_first_of("\n|") == std::string::npos;
}

/// Whether the eye lies on the closed triangle t, which has positive area.
bool eye_lies_on(const Case& c, std::size_t t) {
  const CommonScale scale = scale_of(c.arrays, c.view);
  const auto corner = [&](std::size_t k) {
    return scale(c.arrays.vertices[c.arrays.triangles[t][k]]) - scale(c.view.eye);
  };
  const Integer3 a = corner(0), b = corner(1), d = corner(2), n = cross(b - a, d - a);
  if (n == Integer3{} || dot(n, a) != 0) return false;
  return dot(n, cross(a, b)) >= 0 && dot(n, cross(b, d)) >= 0 && dot(n, cross(d, a)) >= 0;
}

bool eye_lies_on_occluder(const Case& c) {
  if (c.view.projection == Projection::parallel) return false;
  for (std::size_t t = 0; t < c.arrays.triangles.size(); ++t)
    if ((c.arrays.triangle_flags[t] & see_through) == 0 && eye_lies_on(c, t)) return true;
  return false;
}

void require_expected_sets(Arithmetic arithmetic) {
  for (const HardCase& c : catalogue()) {
    if (arithmetic == Arithmetic::mpfr && !c.without_mpfr.empty()) continue;
    INFO(c.because << "\n" << describe(c.input));
    REQUIRE(ids_of(engine_visible(c.input, arithmetic)) == c.visible);
  }
}

/// How many cases show that the oracle makes this mistake.
int caught(Plant plant) {
  int different = 0;
  for (const HardCase& c : catalogue())
    different += ids_of(oracle_visible(c.input.arrays, c.input.view, plant)) != c.visible;
  return different;
}

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

TEST_CASE("the catalogue explains at least forty hard cases") {
  CHECK(catalogue().size() >= 40);
  for (const HardCase& c : catalogue()) {
    INFO(c.input.name);
    CHECK(fits_a_row(c.why));
    CHECK(!c.because.empty());
    CHECK_NOTHROW(check(c.input.view));
  }
}

TEST_CASE("the README of the catalogue ends with the table of its files") {
  const std::string table = hard_table(catalogue());
  INFO("data/hard/README.md has to end with\n" << table);
  CHECK(ends_with(content(folder / "README.md"), "\n\n" + table));
}

TEST_CASE("the oracle gives the expected set of every hard case") {
  for (const HardCase& c : catalogue()) {
    INFO(c.because << "\n" << describe(c.input));
    CHECK(ids_of(oracle_visible(c.input.arrays, c.input.view)) == c.visible);
  }
}

TEST_CASE("the chain gives the expected set of every hard case") { require_expected_sets(Arithmetic::chain); }
TEST_CASE("exact arithmetic gives the expected set of every hard case") {
  require_expected_sets(Arithmetic::exact);
}
TEST_CASE("MPFR gives the expected set of every hard case") { require_expected_sets(Arithmetic::mpfr); }

TEST_CASE("the flag of an eye on a primitive is the expected one in every hard case") {
  for (const HardCase& c : catalogue()) {
    INFO(describe(c.input));
    CHECK(eye_lies_on_occluder(c.input) == c.eye_on_primitive);
    CHECK(visible_from_point(Scene(c.input.arrays), c.input.view).eye_on_primitive == c.eye_on_primitive);
  }
}

TEST_CASE("every visible triangle of a hard case has a witness that holds, by both checkers") {
  PointOptions options;
  options.witnesses = true;
  for (const HardCase& c : catalogue()) {
    INFO(describe(c.input));
    const Scene scene(c.input.arrays);
    const VisibleSet set = visible_from_point(scene, c.input.view, options);
    REQUIRE(set.with(Status::visible) == c.visible);
    REQUIRE(set.witnesses.size() == c.visible.size());
    const RayChecker checker(scene, c.input.view);
    for (std::size_t k = 0; k < c.visible.size(); ++k) {
      REQUIRE(set.witnesses[k].primitive == c.visible[k]);
      REQUIRE(checker.refuse(set.witnesses[k]) == "");
    }
    REQUIRE(verify_witnesses(scene, c.input.view, set) == c.visible.size());
  }
}

TEST_CASE("the subdivision of a hard case shows the expected set and fills the window") {
  PointOptions options;
  options.subdivision = true;
  for (const HardCase& c : catalogue()) {
    INFO(describe(c.input));
    const VisibleSet set = visible_from_point(Scene(c.input.arrays), c.input.view, options);
    std::vector<bool> seen(set.status.size(), false);
    mpq_class uncovered = 0;
    for (const Frame& f : c.input.view.frames)
      uncovered += (mpq_class(f.window.x1) - f.window.x0) * (mpq_class(f.window.y1) - f.window.y0);
    for (const SubdivisionCell& cell : set.subdivision) {
      uncovered -= mpq_class(cell.area);
      for (const PrimitiveId id : cell.visible) seen[id] = true;
    }
    CHECK(uncovered == 0);
    CHECK(ids_of(seen) == c.visible);
    CHECK(set.with(Status::visible) == c.visible);
  }
}

TEST_CASE("plain doubles end on every hard case, and their wrong answers are on record") {
  PointOptions options;
  options.arithmetic = Arithmetic::doubles;
  std::size_t extra = 0, missed = 0;
  for (const HardCase& c : catalogue()) {
    INFO(describe(c.input));
    const VisibleSet set = visible_from_point(Scene(c.input.arrays), c.input.view, options);
    CHECK(set.guarantee == Guarantee::sampled);
    const std::vector<PrimitiveId> answer = set.with(Status::visible);
    CHECK(answer == c.doubles.value_or(c.visible));
    if (c.doubles) CHECK(*c.doubles != c.visible);
    extra += !std::includes(c.visible.begin(), c.visible.end(), answer.begin(), answer.end());
    missed += !std::includes(answer.begin(), answer.end(), c.visible.begin(), c.visible.end());
  }
  // A catalogue on which rounding does no harm in both directions would not be hard.
  CHECK(extra > 0);
  CHECK(missed > 0);
}

TEST_CASE("hard cases catch a dropped occluder") { CHECK(caught(Plant::drop_an_occluder) > 0); }
TEST_CASE("hard cases catch a flipped tie") { CHECK(caught(Plant::flip_a_tie) > 0); }
TEST_CASE("hard cases catch an epsilon") { CHECK(caught(Plant::use_an_epsilon) > 0); }

}  // namespace provis::test
