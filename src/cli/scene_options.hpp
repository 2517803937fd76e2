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

struct ResultHeader;
struct Run;

/// The scene as the command line states it; an empty text is an option that was not given.
struct SceneOptions {
  static constexpr const char* group = "The scene";  ///< in --help

  std::string file;
  std::string sides = "material";
  std::string opacity = "material";
  std::string scene, time, animation, radius;
  bool skip_invalid = false;
  std::string perturb, seed;
  bool seed_has_use = false;  ///< --seed also means something to the command, without --perturb

  /// Adds SCENE and the options of these names.
  void add_to(CLI::App& command);

  /// Throws Error::usage; so that a bad option is reported before a large file is read.
  void validate() const;

  Scene load(Run& run) const;

  /// 0 where none was given.
  std::uint64_t seed_number() const;

  /// What a result records of them, numbers in a form that reads back bit for bit; perturb "0" where the
  /// scene is as the file has it. scene, time, animation, radius and skip_invalid are there only if they were
  /// given.
  std::map<std::string, std::string> recorded() const;

  /// Says in the header which scene was loaded, and how. Keeps options that are there.
  void state(const Scene& scene, ResultHeader& header) const;

  /// The options that a result recorded. Throws Error::invalid_input naming result_file.
  static SceneOptions from_recorded(const std::string& scene_file, const std::string& result_file,
                                    const std::map<std::string, std::string>& options);

 private:
  LoadOptions load_options() const;
  double delta() const;
};

/// Says on standard error what SceneOptions::skip_invalid left out, and where the first few stood.
void warn_of_left_out(const Scene& scene, const std::string& file);

}  // namespace provis
