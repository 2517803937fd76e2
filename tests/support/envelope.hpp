#pragma once
// CGAL's lower_envelope_3 as third opinion, in a child process because degenerate input can crash it.

#include <string>
#include <vector>

#include "tests/support/case.hpp"

namespace provis::test {

struct EnvelopeOpinion {
  enum Outcome {
    answered,  ///< visible holds the ids in ascending order
    crashed,   ///< the child died, ran out of time or broke an assertion
    refused,   ///< the child does not take such a case
  };
  Outcome outcome = refused;
  std::vector<PrimitiveId> visible;
  std::string reason;  ///< of a crash or refusal
};

/// Runs the child `envelope_child` on the case; it is killed after the given number of seconds.
EnvelopeOpinion ask_envelope(const Case& c, int limit_seconds = 20);

}  // namespace provis::test
