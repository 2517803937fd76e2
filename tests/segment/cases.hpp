#pragma once
// Segment queries made of the generator's cases, and answers in a form that can be compared.

#include <string>

#include "provis/segment.hpp"
#include "tests/support/case.hpp"

namespace provis::test {

struct SegmentCase {
  Case scene;  ///< its view is not used
  SegmentView view;
};

/// A generated scene, a path near its eye that often lies in planes and along edges, few pixels.
SegmentCase generate_segment(std::uint64_t seed);

std::string describe(const SegmentCase& c);

/// Everything of an answer but costs and rounded lengths.
struct SegmentAnswer {
  std::vector<PrimitiveId> visible, boundary;
  std::vector<std::uint64_t> pixels;
  std::vector<std::string> sights;  ///< a line per pixel

  friend bool operator==(const SegmentAnswer&, const SegmentAnswer&) = default;
};

SegmentAnswer answer(const Scene& scene, const SegmentView& view, SegmentOptions options = {},
                     const Context& context = {});

}  // namespace provis::test
