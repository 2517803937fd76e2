#pragma once
// What all blocks of all frames saw, added up in a fixed order.

#include <map>

#include "src/segment/block.hpp"

namespace provis {

/// A glimpse and the frame that it belongs to.
struct FrameGlimpse {
  int frame = 0;
  Glimpse glimpse;
};

class Tally {
 public:
  explicit Tally(std::size_t primitives)
      : pixels_(primitives, 0), length_(primitives, 0), inner_(primitives, 0) {}

  void add(int frame, const BlockOutcome& outcome);

  /// Status, boundary and measures of each primitive.
  void report(SegmentSet& set) const;

  /// The first glimpse of each primitive, by frame, row and column.
  const std::map<PrimitiveId, FrameGlimpse>& glimpses() const { return glimpses_; }
  const SignCounts& signs() const { return signs_; }

 private:
  std::vector<std::uint64_t> pixels_;
  std::vector<double> length_;
  std::vector<std::uint8_t> inner_;
  std::map<PrimitiveId, FrameGlimpse> glimpses_;
  SignCounts signs_;
};

}  // namespace provis
