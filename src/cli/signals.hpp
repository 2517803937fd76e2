#pragma once
// Ctrl-C: a flag that long computations look at.

#include <atomic>

namespace provis {

/// From now on SIGINT and SIGTERM set the returned flag instead of ending the program.
std::atomic<bool>& catch_interrupts();

}  // namespace provis
