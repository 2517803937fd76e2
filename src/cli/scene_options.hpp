#pragma once
// The options that say which scene a command works on; the hash covers all of them (R1).

#include <cstdint>
#include <map>
#include <string>

#include "provis/scene.hpp"

namespace CLI {
class App;
}

namespace provis {

struct Run;

/// The scene as the command line states it.
struct SceneOptions {
  std::string file;
  std::string sides = "material";
  std::string opacity = "material";
  std::string perturb;  ///< empty: not perturbed
  std::string seed;

  /// Adds SCENE, --sides, --opacity, --perturb and --seed.
  void add_to(CLI::App& command);

  /// Throws Error::usage; so that a bad option is reported before a large file is read.
  void validate() const;

  Scene load(Run& run) const;

  /// What a result records of them; perturb "0" where the scene is as the file has it.
  std::map<std::string, std::string> recorded() const;

  /// The options that a result recorded. Throws Error::invalid_input naming result_file.
  static SceneOptions from_recorded(const std::string& scene_file, const std::string& result_file,
                                    const std::map<std::string, std::string>& options);

 private:
  double delta() const;
  std::uint64_t seed_number() const;
};

}  // namespace provis
