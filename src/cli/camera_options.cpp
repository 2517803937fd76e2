#include "src/cli/camera_options.hpp"

#include <algorithm>

#include "src/cli/arguments.hpp"

namespace provis {

bool CameraOptions::camera() const {
  const auto all = {&dir, &look_at, &right, &up, &forward, &window, &fovy};
  return std::any_of(all.begin(), all.end(), [](const std::string* text) { return !text->empty(); });
}

ViewRequest CameraOptions::request() const {
  ViewRequest request;
  request.dir = optional_vec3("--dir", dir);
  request.look_at = optional_vec3("--look-at", look_at);
  request.right = optional_vec3("--right", right);
  request.up = optional_vec3("--up", up);
  request.forward = optional_vec3("--forward", forward);
  if (!window.empty()) request.window = parse_window("--window", window);
  if (!fovy.empty()) request.fovy_degrees = parse_number("--fovy", fovy);
  return request;
}

std::optional<Vec3d> optional_vec3(const std::string& option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return parse_vec3(option, text);
}

}  // namespace provis
