#pragma once
// What all JSON writers of this folder share.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "provis/scene.hpp"

namespace provis {

/// One line. Bytes that are no UTF-8, which a file's name may hold, become the replacement character.
inline std::string json_text(const nlohmann::ordered_json& value) {
  return value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// A space and the name; nothing where it is empty. What a file calls its parts may hold anything, line ends
/// too: JSON's quotes make one line of it.
inline std::string quoted_name(const std::string& name) {
  return name.empty() ? name : fmt::format(" {}", json_text(name));
}

/// The index, or null in place of -1.
inline nlohmann::ordered_json index_json(std::int32_t index) {
  return index < 0 ? nlohmann::ordered_json() : nlohmann::ordered_json(index);
}

/// An array of {place, reason}.
inline nlohmann::ordered_json left_out_json(std::span<const LeftOut> left_out) {
  auto list = nlohmann::ordered_json::array();
  for (const LeftOut& item : left_out) list.push_back({{"place", item.place}, {"reason", item.reason}});
  return list;
}

}  // namespace provis
