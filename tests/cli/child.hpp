#pragma once
// The built program as a child process, and a small scene for it.

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace provis::test {

struct Outcome {
  int status = -1;  ///< exit status, or 128 + the signal that ended it
  std::string out, err;
};

/// Arguments of the program.
using Words = std::vector<std::string>;

inline Words operator+(Words a, const Words& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// One run of the program.
class Child {
 public:
  /// Starts it; shell, if not empty, is run first ("ulimit -v 100000").
  explicit Child(const std::vector<std::string>& arguments, const std::string& shell = "");

  pid_t pid() const { return pid_; }
  Outcome wait();

 private:
  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;  ///< nameless files that take what it says
};

/// Runs it to its end.
Outcome provis_run(const std::vector<std::string>& arguments, const std::string& shell = "");

/// Writes a scene to look at from the origin along -z: triangle 0 hides 1; 2 is beside them, 3 has no area.
std::string write_small_scene(const std::filesystem::path& file);

/// The same with two invalid faces before triangle 2: they stand in lines 21 and 22.
std::string write_broken_scene(const std::filesystem::path& file);

/// Three spheres, the second with a velocity, as an element of their own.
std::string write_particles(const std::filesystem::path& file);

}  // namespace provis::test
