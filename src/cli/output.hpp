#pragma once
// Where a result goes: standard output, or a file that appears whole or not at all.

#include <memory>
#include <ostream>
#include <string>

namespace provis {

class AtomicFile;

/// Opened before the work begins, so that a place that cannot be written is known at once.
class Output {
 public:
  /// "-" is standard output. Throws Error::output.
  explicit Output(const std::string& name);
  ~Output();
  Output(Output&&) noexcept;

  std::ostream& stream();

  /// Call it once, last. Throws Error::output if anything did not arrive.
  void commit();

 private:
  std::unique_ptr<AtomicFile> file_;  ///< null for standard output
};

/// Text to standard output, flushed and checked.
void print(const std::string& text);

/// Talk gives way to a result that is on its way to standard output: then it goes to standard error.
void say(const std::string& text, bool result_on_stdout);

}  // namespace provis
