#pragma once
// The options that name simplified versions of the scene.

#include <memory>
#include <optional>
#include <string>

#include "provis/level_of_detail.hpp"
#include "src/cli/scene_options.hpp"

namespace provis {

/// The two scenes and the level of detail that refers to them.
struct LoadedDetail {
  std::unique_ptr<const Scene> occluders, shell;
  std::string objects_hash;  ///< SHA-256 of the file
  LevelOfDetail detail;
};

struct DetailOptions {
  static constexpr const char* group = "Level of detail";  ///< in --help

  std::string occluders, shell, objects;

  void add_to(CLI::App& command);

  /// Throws Error::usage unless all are given, with a method that has an upper set, or none.
  void validate(const std::string& method) const;

  /// Nothing where the options were not given. The files are loaded as the full scene was, and verified.
  std::optional<LoadedDetail> load(const SceneOptions& source, const Scene& full, Run& run) const;

  /// Records the files and their hashes.
  void state(const LoadedDetail& loaded, std::map<std::string, std::string>& options) const;
};

}  // namespace provis
