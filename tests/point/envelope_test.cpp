// CGAL's lower envelope as a third opinion on the engine.

#include <catch2/catch.hpp>

#include "tests/point/answers.hpp"
#include "tests/support/envelope.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/generator.hpp"

namespace provis::test {

TEST_CASE("CGAL's lower envelope gives the engine's set wherever it answers") {
  int agreed = 0, crashed = 0, refused = 0;
  // Other seeds than those on which the oracle was compared with it.
  constexpr std::uint64_t offset = 1'000'000;
  const std::vector<std::uint64_t> all = seeds(6);
  for (const std::uint64_t seed : all) {
    const Case c = generate(seed + offset);
    const EnvelopeOpinion opinion = ask_envelope(c);
    switch (opinion.outcome) {
      case EnvelopeOpinion::crashed:
        ++crashed;
        continue;
      case EnvelopeOpinion::refused:
        ++refused;
        continue;
      case EnvelopeOpinion::answered:
        break;
    }
    INFO(describe(c));
    REQUIRE(ids_of(engine_visible(c)) == opinion.visible);
    ++agreed;
  }
  WARN("envelope: " << agreed << " agreed, " << crashed << " crashed, " << refused << " refused");
  if (all.size() >= 20) CHECK(static_cast<std::size_t>(agreed) * 100 >= all.size() * 80);
}

}  // namespace provis::test
