// Witnesses along a segment: each holds by the oracle's rays, and whatever is in R10° has one.

#include <catch2/catch.hpp>

#include <algorithm>
#include <optional>

#include "tests/segment/answers.hpp"
#include "tests/support/environment.hpp"

namespace provis::test {
namespace {

using Rational3 = Vec3<Rational>;

Rational exact(const Dyadic& d) {
  Rational value{Integer(d.mantissa)};
  const auto by = static_cast<mp_bitcnt_t>(std::abs(d.exponent));
  d.exponent >= 0 ? mpq_mul_2exp(value.get_mpq_t(), value.get_mpq_t(), by)
                  : mpq_div_2exp(value.get_mpq_t(), value.get_mpq_t(), by);
  return value;
}

Rational3 exact(const Vec3<Dyadic>& v) { return {exact(v.x), exact(v.y), exact(v.z)}; }
Rational3 exact(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// The t strictly inside (0, 1) at which the camera is there; 1/2 for a segment without length.
std::optional<Rational> time_at(const SegmentView& view, const Rational3& there) {
  const Rational3 from = exact(view.from), way = exact(view.to) - from, gone = there - from;
  if (view.from == view.to) return gone == Rational3{} ? std::optional<Rational>({1, 2}) : std::nullopt;
  const Rational t = dot(gone, way) / dot(way, way);
  if (gone != t * way || t <= 0 || t >= 1) return {};
  return t;
}

/// The pixels whose centre lies in this direction.
std::vector<Pixel> pixels_along(const SegmentView& view, const Rational3& direction) {
  std::vector<Pixel> found;
  for_pixels(view, [&](const Pixel& p) {
    const Rational3 centre = exact(ray_along(view, p, view.from).direction);
    if (cross(centre, direction) == Rational3{} && dot(centre, direction) > 0) found.push_back(p);
  });
  return found;
}

/// Why a witness proves nothing; empty if it holds.
std::string refuse(const SegmentCase& c, const SegmentOracle& oracle, const Witness& w) {
  const std::optional<Rational> t = time_at(c.view(), exact(w.origin));
  if (!t) return "its origin is not inside the segment";
  if (c.to != c.start.view.eye && oracle.on_occluder(*t)) return "its origin lies on an occluder";
  const std::vector<Pixel> pixels = pixels_along(c.view(), exact(w.direction));
  if (pixels.empty()) return "its direction is no pixel's centre";
  const Look look = oracle.look(pixels.front(), *t);
  const bool proper = std::binary_search(look.proper.begin(), look.proper.end(), w.primitive);
  return proper ? "" : "its ray does not see the primitive";
}

}  // namespace

TEST_CASE("what is in R10° has a witness that holds, and asking for witnesses changes no answer") {
  SegmentOptions options;
  options.witnesses = true;
  std::size_t held = 0;
  for (const std::uint64_t seed : seeds(20)) {
    const SegmentCase c = generate_segment(seed);
    INFO(describe(c));
    SegmentSet set;
    const Answer answer = engine_answer(c, options, {}, &set);
    REQUIRE(difference(answer, engine_answer(c)) == "");
    std::vector<PrimitiveId> claimed, proper;
    for (const Witness& w : set.set.witnesses) claimed.push_back(w.primitive);
    std::set_difference(answer.visible.begin(), answer.visible.end(), answer.boundary.begin(),
                        answer.boundary.end(), std::back_inserter(proper));
    REQUIRE(text(claimed) == text(proper));
    const SegmentOracle oracle(c.start.arrays, c.view());
    for (const Witness& w : set.set.witnesses) {
      INFO("triangle " << w.primitive);
      REQUIRE(refuse(c, oracle, w) == "");
      ++held;
    }
  }
  CHECK(held > 0);
}

}  // namespace provis::test
