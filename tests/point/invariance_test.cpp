// What must not change a set, and what may only shrink it (semantics, "Invariances").

#include <catch2/catch.hpp>

#include "tests/point/answers.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/transform.hpp"

namespace provis::test {
namespace {

constexpr int share = 12;  ///< percent of all cases

void check(const std::vector<bool>& expected, const Variant& variant) {
  INFO(describe(variant.changed));
  REQUIRE(ids_of(pull_back(variant, engine_visible(variant.changed))) == ids_of(expected));
}

void check(const std::vector<bool>& expected, const std::optional<Variant>& variant) {
  if (variant) check(expected, *variant);
}

/// Runs body(case, its answer, seed) on a share of the generated cases.
template <class Body>
void for_cases(const Body& body) {
  for (const std::uint64_t seed : seeds(share)) {
    const Case c = generate(seed);
    INFO(describe(c));
    body(c, engine_visible(c), seed);
  }
}

}  // namespace

TEST_CASE("permuting triangles changes no set") {
  for_cases(
      [](const Case& c, const auto& set, std::uint64_t seed) { check(set, permute_triangles(c, seed)); });
}

TEST_CASE("rotating a triangle's vertices changes no set") {
  for_cases([](const Case& c, const auto& set, std::uint64_t seed) { check(set, rotate_corners(c, seed)); });
}

TEST_CASE("splitting shared vertices changes no set") {
  for_cases([](const Case& c, const auto& set, std::uint64_t) { check(set, split_vertices(c)); });
}

TEST_CASE("scaling by a power of two changes no set") {
  for_cases([](const Case& c, const auto& set, std::uint64_t seed) {
    check(set, scale(c, seed % 2 == 0 ? 40 : -40));
    check(set, scale(c, 1));
  });
}

TEST_CASE("translating scene and camera together changes no set") {
  for_cases([](const Case& c, const auto& set, std::uint64_t) {
    check(set, translate(c, {1, -2, 4}));
    check(set, translate(c, {-1024, 0.5, 0}));
  });
}

TEST_CASE("permuting axes changes no set") {
  for_cases([](const Case& c, const auto& set, std::uint64_t seed) {
    check(set, permute_axes(c, {1, 2, 0}));
    check(set, seed % 2 == 0 ? permute_axes(c, {1, 0, 2}) : permute_axes(c, {0, 2, 1}));
  });
}

TEST_CASE("mirroring with swapped windings changes no set") {
  for_cases([](const Case& c, const auto& set, std::uint64_t seed) {
    check(set, mirror(c, static_cast<int>(seed % 3)));
  });
}

TEST_CASE("cutting a triangle leaves it visible iff a part is") {
  for_cases([](const Case& c, const auto& set, std::uint64_t seed) { check(set, cut_triangles(c, seed)); });
}

TEST_CASE("adding an occluder makes no other triangle visible") {
  for_cases([](const Case& c, const std::vector<bool>& before, std::uint64_t seed) {
    const Variant v = add_triangle(c, seed);
    INFO(describe(v.changed));
    const std::vector<bool> after = pull_back(v, engine_visible(v.changed));
    for (std::size_t t = 0; t < before.size(); ++t) REQUIRE((before[t] || !after[t]));
  });
}

}  // namespace provis::test
