#pragma once
// The lists of what the second evaluator, reference_loader.py, computes of published scenes.

#include <string>
#include <vector>

#include "tests/scene/files.hpp"

namespace provis {

/// The words of each line of a list in this folder; lines that begin with # are comments.
inline std::vector<std::vector<std::string>> expected_lines(const std::string& list) {
  std::vector<std::vector<std::string>> lines;
  std::istringstream text(read_text(std::string(PROVIS_SOURCE_DIR) + "/tests/scene/" + list));
  for (std::string line; std::getline(text, line);) {
    if (line.empty() || line[0] == '#') continue;
    lines.emplace_back();
    std::istringstream words(line);
    for (std::string word; words >> word;) lines.back().push_back(word);
  }
  REQUIRE_FALSE(lines.empty());
  return lines;
}

}  // namespace provis
