#pragma once
// Segment queries made of the generator's cases, and answers in a form that can be compared.

#include <string>

#include "provis/segment.hpp"
#include "tests/support/case.hpp"

namespace provis::test {

struct EngineCase {
  Case scene;  ///< its view is not used
  SegmentView view;
};

/// A generated scene, a path near its eye that often lies in planes and along edges, few pixels.
EngineCase generate_engine_case(std::uint64_t seed);

std::string describe(const EngineCase& c);

/// Everything of an answer but costs and rounded lengths.
struct PrintedAnswer {
  std::vector<PrimitiveId> visible, boundary;
  std::vector<std::uint64_t> pixels;
  std::vector<std::string> sights;  ///< a line per pixel

  friend bool operator==(const PrintedAnswer&, const PrintedAnswer&) = default;
};

PrintedAnswer answer(const Scene& scene, const SegmentView& view, SegmentOptions options = {},
                     const Context& context = {});

}  // namespace provis::test
