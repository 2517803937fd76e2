// The oracle against CGAL's lower envelope, which shares nothing with it but the reader of cases.

#include <catch2/catch.hpp>

#include "tests/support/envelope.hpp"
#include "tests/support/generator.hpp"
#include "tests/support/oracle.hpp"

namespace provis::test {

TEST_CASE("CGAL's lower envelope gives the oracle's answer on generated cases") {
  const int count = 300;
  int agreed = 0, crashed = 0, refused = 0;
  for (int seed = 0; seed < count; ++seed) {
    const Case c = generate(static_cast<std::uint64_t>(seed));
    const EnvelopeOpinion opinion = ask_envelope(c);
    if (opinion.outcome == EnvelopeOpinion::crashed) ++crashed;
    if (opinion.outcome == EnvelopeOpinion::refused) ++refused;
    if (opinion.outcome != EnvelopeOpinion::answered) continue;

    std::vector<PrimitiveId> expected;
    const std::vector<bool> visible = oracle_visible(c.arrays, c.view);
    for (PrimitiveId t = 0; t < visible.size(); ++t) {
      if (visible[t]) expected.push_back(t);
    }
    INFO(describe(c));
    REQUIRE(opinion.visible == expected);
    ++agreed;
  }
  WARN("envelope: " << agreed << " agreed, " << crashed << " crashed, " << refused << " refused of "
                    << count);
  CHECK(agreed * 100 >= count * 80);
}

TEST_CASE("a child that does not end in time counts as crashed") {
  const EnvelopeOpinion opinion = ask_envelope(random_soup(1, 1500), 1);
  CHECK(opinion.outcome == EnvelopeOpinion::crashed);
  CHECK(opinion.reason == "out of time");
}

TEST_CASE("a case beyond the child's reach is refused") {
  CHECK(ask_envelope(random_soup(1, 2001)).outcome == EnvelopeOpinion::refused);
}

}  // namespace provis::test
