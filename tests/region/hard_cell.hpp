#pragma once
// The catalogue of hard cells, data/hard/cell: scene, cell, and the answer that follows by reasoning.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "provis/cell.hpp"

namespace provis::test {

/// One file of the catalogue; data/hard/cell/README.md describes the format.
struct HardCell {
  std::string name;     ///< like the file, without its ending
  std::string why;      ///< what makes it hard
  std::string because;  ///< the reasoning that leads to the answer
  SceneArrays arrays;
  ViewCell cell;
  std::vector<PrimitiveId> visible, undecided;

  struct Samples {
    PixelGrid pixels;
    std::vector<PrimitiveId> visible, boundary;
  };
  std::optional<Samples> samples;
};

/// Every case of a folder, by name.
///
/// Throws:     std::runtime_error naming the file and what is wrong with it
std::vector<HardCell> load_hard_cells(const std::filesystem::path& folder);

/// The table that data/hard/cell/README.md ends with, one row per case.
std::string hard_table(const std::vector<HardCell>& cases);

}  // namespace provis::test
