#pragma once
// Answers along a segment in a form in which engine and oracle, and a case and its variants, compare.

#include <string>
#include <vector>

#include "tests/support/segment_cases.hpp"
#include "tests/support/segment_oracle.hpp"

namespace provis::test {

/// What has to be the same, whoever answers.
struct Answer {
  std::vector<PrimitiveId> visible, boundary;
  std::vector<ExactSights> pixels;

  friend bool operator==(const Answer&, const Answer&) = default;
};

Answer answer_of(const SegmentAnswer& oracle);

/// The engine's answer to a case, its pixels as they were told one by one; in `set` all that it said.
Answer engine_answer(const SegmentCase& c, SegmentOptions options = {}, const Context& context = {},
                     SegmentSet* set = nullptr);

/// Where two answers differ first, in words; empty if nowhere.
std::string difference(const Answer& engine, const Answer& expected);

/// Where the engine's measure of importance is not the oracle's, rounded; empty if nowhere.
std::string difference(const std::vector<Seen>& engine, const std::vector<ExactSeen>& expected);

ExactSights exact(const PixelSights& sights);

/// Joins neighbours that show one set.
ExactSights joined(const ExactSights& sights);

std::string text(const std::vector<PrimitiveId>& ids);
std::string text(const ExactSights& sights);

}  // namespace provis::test
