// What must not change an answer along a segment, and what changes it in a known way.

#include <catch2/catch.hpp>

#include <algorithm>

#include "tests/segment/variants.hpp"
#include "tests/support/environment.hpp"

namespace provis::test {
namespace {

constexpr int share = 12;  ///< percent of all cases

/// Runs body(case, the engine's answer, seed) on a share of the generated cases.
template <class Body>
void for_cases(const Body& body) {
  for (const std::uint64_t seed : seeds(share)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    body(c, engine_answer(c), seed);
  }
}

void check(const Answer& expected, const std::optional<SegmentVariant>& variant) {
  if (!variant) return;
  INFO(describe(variant->changed));
  REQUIRE(difference(pull_back(*variant, engine_answer(variant->changed)), expected) == "");
}

/// change(case with the segment's end as one more vertex, seed) must change no answer.
template <class Change>
void check_invariance(const Change& change) {
  for_cases([&](const SegmentCase& c, const Answer& answer, std::uint64_t seed) {
    check(answer, changed(c, [&](const Case& start) { return std::optional<Variant>(change(start, seed)); }));
  });
}

/// What is visible at a pixel between two times within one sight of each list.
bool shows_no_more(const ExactSights& more, const ExactSights& less, PrimitiveId but) {
  for (const ExactSight& m : more.sights) {
    for (const ExactSight& l : less.sights) {
      if (std::max(m.from, l.from) >= std::min(m.to, l.to)) continue;  // no time in common
      for (const PrimitiveId id : m.visible)
        if (id != but && !std::binary_search(l.visible.begin(), l.visible.end(), id)) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("permuting triangles changes no answer along a segment") {
  check_invariance([](const Case& c, std::uint64_t seed) { return permute_triangles(c, seed); });
}

TEST_CASE("rotating a triangle's vertices changes no answer along a segment") {
  check_invariance([](const Case& c, std::uint64_t seed) { return rotate_corners(c, seed); });
}

TEST_CASE("splitting shared vertices changes no answer along a segment") {
  for_cases([](const SegmentCase& c, const Answer& answer, std::uint64_t) {
    Variant v = split_vertices(c.start);
    check(answer, SegmentVariant{{std::move(v.changed), c.to, c.pixels}, std::move(v.parts)});
  });
}

TEST_CASE("scaling by a power of two changes no answer along a segment") {
  check_invariance([](const Case& c, std::uint64_t seed) { return scale(c, seed % 2 == 0 ? 40 : -40); });
  check_invariance([](const Case& c, std::uint64_t) { return scale(c, 1); });
}

TEST_CASE("translating scene and segment together changes no answer") {
  check_invariance([](const Case& c, std::uint64_t) { return translate(c, {-1024, 0.5, 3}); });
}

TEST_CASE("permuting axes changes no answer along a segment") {
  check_invariance([](const Case& c, std::uint64_t) { return permute_axes(c, {1, 2, 0}); });
  check_invariance([](const Case& c, std::uint64_t) { return permute_axes(c, {1, 0, 2}); });
}

TEST_CASE("mirroring with swapped windings changes no answer along a segment") {
  check_invariance([](const Case& c, std::uint64_t seed) { return mirror(c, static_cast<int>(seed % 3)); });
}

TEST_CASE("cutting a triangle changes no sight: it is seen where a part is") {
  for_cases([](const SegmentCase& c, Answer expected, std::uint64_t seed) {
    const auto v = changed(c, [&](const Case& start) { return cut_triangles(start, seed); });
    if (!v) return;
    INFO(describe(v->changed));
    Answer found = pull_back(*v, engine_answer(v->changed));
    // A pixel that looks at the cut all the time meets the border of both parts, and nothing inside.
    REQUIRE(std::includes(found.boundary.begin(), found.boundary.end(), expected.boundary.begin(),
                          expected.boundary.end()));
    found.boundary = expected.boundary;
    REQUIRE(difference(found, expected) == "");
  });
}

TEST_CASE("a segment from its end to its beginning shows the same, mirrored in time") {
  for_cases([](const SegmentCase& c, const Answer& answer, std::uint64_t) {
    REQUIRE(difference(reversed(engine_answer(reversed(c))), answer) == "");
  });
}

TEST_CASE("the halves of a segment show together what the whole shows") {
  std::size_t cut = 0;
  for_cases([&](const SegmentCase& c, const Answer& answer, std::uint64_t) {
    const auto parts = halves(c);
    if (!parts) return;
    ++cut;
    REQUIRE(difference(united(engine_answer(parts->first), engine_answer(parts->second)), answer) == "");
  });
  if (seeds(share).size() > 20) CHECK(2 * cut > seeds(share).size());
}

TEST_CASE("adding an occluder makes no other triangle visible at any time") {
  for_cases([](const SegmentCase& c, const Answer& before, std::uint64_t seed) {
    const auto v = changed(c, [&](const Case& start) { return std::optional(add_triangle(start, seed)); });
    INFO(describe(v->changed));
    const Answer after = engine_answer(v->changed);
    const auto added = static_cast<PrimitiveId>(c.start.arrays.triangles.size());
    for (std::size_t p = 0; p < before.pixels.size(); ++p) {
      INFO(text(before.pixels[p]) << "\n" << text(after.pixels.at(p)));
      REQUIRE(shows_no_more(after.pixels.at(p), before.pixels[p], added));
    }
  });
}

}  // namespace provis::test
