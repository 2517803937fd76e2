#pragma once
// Words of the result format that its writer and its reader share.

#include <algorithm>
#include <array>
#include <string_view>

namespace provis {

inline constexpr std::string_view result_format = "provis.visible-set";
inline constexpr int result_version = 1;

/// Whether a member of "query" describes the view; every other member is an option as it was given.
inline bool is_view_key(std::string_view key) {
  constexpr std::array<std::string_view, 13> keys = {
      "kind",   "projection", "eye",    "right", "up",    "forward",   "window",
      "frames", "segments",   "pixels", "lower", "upper", "directions"};
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace provis
