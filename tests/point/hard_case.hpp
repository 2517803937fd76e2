#pragma once
// The catalogue of hard cases, data/hard: one scene, one view and the answer that follows by reasoning.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/case.hpp"

namespace provis::test {

/// One file of the catalogue; data/hard/README.md describes the format.
struct HardCase {
  Case input;                        ///< named like the file, without its ending
  std::string why;                   ///< what makes it hard
  std::string because;               ///< the reasoning that leads to the expected set
  std::vector<PrimitiveId> visible;  ///< the expected set, ascending
  bool eye_on_primitive = false;
  std::optional<std::vector<PrimitiveId>> doubles;  ///< what plain float64 signs answer, where that is wrong
  std::string without_mpfr;                         ///< why the MPFR policy is not tried; empty if it is
};

/// Every case of a folder, by name.
///
/// Throws:     std::runtime_error naming the file and what is wrong with it: members that are unknown,
///             missing or of the wrong type, ids out of range or not ascending
std::vector<HardCase> load_hard_cases(const std::filesystem::path& folder);

/// The table that data/hard/README.md ends with, one row per case.
std::string hard_table(const std::vector<HardCase>& cases);

}  // namespace provis::test
