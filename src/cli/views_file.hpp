#pragma once
// Files of named views; both formats are described in README.md.

#include <string>

#include "src/cli/view_request.hpp"

namespace provis {

/// The view called name; if several scenes have one of that name, the one of scene_file's file name.
///
/// Throws:     Error::invalid_input (the file is not what it should be), Error::usage (no such view, or
///             more than one)
ViewRequest read_named_view(const std::string& file, const std::string& name, const std::string& scene_file);

}  // namespace provis
