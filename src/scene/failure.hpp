#pragma once
// How the loaders fail: a code, a place inside the file, and one sentence.

#include <string>

#include "provis/error.hpp"

namespace provis {

[[noreturn]] void fail_invalid(std::string place, const std::string& what);
[[noreturn]] void fail_unsupported(std::string place, const std::string& what);

/// The message without the place in front of it.
std::string what_of(const Error& error);

/// The same failure with the file's name in front of its place.
Error in_file(const std::string& file, const Error& error);

}  // namespace provis
