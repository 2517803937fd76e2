#pragma once
// What the catalogues of hard cases have in common: members that are checked, scenes, and lists of ids.

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "provis/scene.hpp"

namespace provis::test::hard_json {

using Json = nlohmann::json;

/// A misspelt member would otherwise go unread, and what it says untested.
inline void check_members(const Json& object, const std::set<std::string>& known) {
  for (const auto& [key, value] : object.items()) {
    if (known.count(key) == 0) throw std::runtime_error("unknown member '" + key + "'");
  }
}

/// get<double>() would take true as well.
inline double number(const Json& value) {
  if (!value.is_number()) throw std::runtime_error(value.dump() + " is no number");
  return value.get<double>();
}

/// get<std::uint32_t>() would take -1 and 1.5 as well.
inline std::uint32_t index(const Json& value, std::size_t count) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count) {
    throw std::runtime_error(value.dump() + " is no index below " + std::to_string(count));
  }
  return value.get<std::uint32_t>();
}

/// The list itself, which has to have this many items.
inline const Json& items(const Json& value, std::size_t count) {
  if (!value.is_array() || value.size() != count) {
    throw std::runtime_error(value.dump() + " is no list of " + std::to_string(count));
  }
  return value;
}

inline Vec3d vec3(const Json& value) {
  const Json& v = items(value, 3);
  return {number(v[0]), number(v[1]), number(v[2])};
}

/// Ascending ids below count.
inline std::vector<PrimitiveId> ids(const Json& value, std::size_t count) {
  std::vector<PrimitiveId> list;
  for (const Json& id : items(value, value.size())) list.push_back(index(id, count));
  if (std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) != list.end()) {
    throw std::runtime_error(value.dump() + " is not ascending");
  }
  return list;
}

/// vertices, triangles and flags.
inline SceneArrays scene(const Json& file) {
  SceneArrays arrays;
  for (const Json& v : file.at("vertices")) arrays.vertices.push_back(vec3(v));
  const std::size_t points = arrays.vertices.size();
  for (const Json& t : file.at("triangles")) {
    items(t, 3);
    arrays.triangles.push_back({index(t[0], points), index(t[1], points), index(t[2], points)});
  }
  const std::size_t count = arrays.triangles.size();
  arrays.triangle_flags.assign(count, 0);
  const Json flags = file.value("flags", Json::object());
  check_members(flags, {"single_sided", "see_through"});
  const auto set = [&](const char* name, PrimitiveFlag flag) {
    for (const PrimitiveId id : ids(flags.value(name, Json::array()), count)) {
      arrays.triangle_flags[id] = static_cast<std::uint8_t>(arrays.triangle_flags[id] | flag);
    }
  };
  set("single_sided", single_sided);
  set("see_through", see_through);
  return arrays;
}

/// "0-3, 7"; "none" for an empty set.
inline std::string ids_text(const std::vector<PrimitiveId>& list) {
  std::string out;
  for (std::size_t first = 0; first < list.size();) {
    std::size_t last = first;
    while (last + 1 < list.size() && list[last + 1] == list[last] + 1) ++last;
    out += (out.empty() ? "" : ", ") + std::to_string(list[first]);
    if (last > first) out += (last == first + 1 ? ", " : "-") + std::to_string(list[last]);
    first = last + 1;
  }
  return out.empty() ? "none" : out;
}

}  // namespace provis::test::hard_json
