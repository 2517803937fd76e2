#pragma once
// The catalogue of hard segments, data/hard/segment: scene, segment, pixels, and the answer that follows by
// reasoning.

#include <filesystem>
#include <string>
#include <vector>

#include "tests/segment/answers.hpp"

namespace provis::test {

/// One file of the catalogue; data/hard/segment/README.md describes the format.
struct HardSegment {
  SegmentCase input;    ///< named like the file, without its ending
  std::string why;      ///< what makes it hard
  std::string because;  ///< the reasoning that leads to the answer
  Answer answer;
};

/// Every case of a folder, by name.
///
/// Throws:     std::runtime_error naming the file and what is wrong with it
std::vector<HardSegment> load_hard_segments(const std::filesystem::path& folder);

/// The table that data/hard/segment/README.md ends with, one row per case.
std::string hard_table(const std::vector<HardSegment>& cases);

}  // namespace provis::test
