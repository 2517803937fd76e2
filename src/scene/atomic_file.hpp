#pragma once
// Output that appears whole or not at all.

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>

namespace provis {

/// A file that is written aside and takes its name on commit().
///
/// Guarantee:  without a successful commit() the named file is as it was, and nothing is left beside it
/// Degenerate: a device or pipe (/dev/full, /dev/stdout) is written in place: a rename would replace it;
///             of a symbolic link the target is replaced, not the link
/// Throws:     Error::output naming the path, with the system's reason
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where the content goes. A failed write shows in the stream's state and, at the latest, in commit().
  std::ostream& stream();

  /// Flushes, checks and renames. Call it once, last.
  void commit();

 private:
  class Buffer;

  [[noreturn]] void fail(int error) const;
  void create_aside(const std::filesystem::path& target);

  std::string name_;              ///< as the caller gave it, for messages
  std::filesystem::path target_;  ///< what commit() replaces; empty if written in place
  std::filesystem::path aside_;   ///< what is written meanwhile; empty if written in place
  std::unique_ptr<Buffer> buffer_;
  std::unique_ptr<std::ostream> stream_;
};

}  // namespace provis
