#pragma once
// What all commands that look through a window can be told about it.

#include <optional>
#include <string>

#include "src/cli/view_request.hpp"

namespace provis {

/// The options of these names, as text; an empty one was not given. Each command says in its --help what they
/// mean to it.
struct CameraOptions {
  std::string dir, look_at, right, up, forward, window, fovy;

  /// Whether any was given.
  bool camera() const;

  /// What they state of a view; its eye, pixels and projection stand elsewhere.
  ///
  /// Throws:     Error::usage naming the option
  ViewRequest request() const;
};

/// Throws:     Error::usage naming the option
std::optional<Vec3d> optional_vec3(const std::string& option, const std::string& text);

}  // namespace provis
