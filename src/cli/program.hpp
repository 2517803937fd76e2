#pragma once
// The whole command line tool, given its arguments.

#include "src/cli/run.hpp"

namespace provis {

/// Parses the arguments and does what they say. Returns the exit status; failures are told on standard error.
int run_program(int argc, const char* const* argv, Run& run);

}  // namespace provis
