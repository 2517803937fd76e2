#pragma once
// How much memory a part of the program took at most.

#include <cstddef>

namespace provis {

/// Resident memory from the making of the object on. The system keeps one such peak for the whole program, so
/// there is use for one object at a time.
class PeakMemory {
 public:
  /// Gives what was freed back to the system, and lets the peak start anew.
  PeakMemory();

  /// Bytes at the peak beyond what was resident at the start; 0 where the system does not say.
  std::size_t bytes() const;

 private:
  std::size_t before_;
};

}  // namespace provis
