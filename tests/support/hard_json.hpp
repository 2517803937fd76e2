#pragma once
// What the catalogues of hard cases have in common: members that are checked, scenes, and lists of ids.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "provis/scene.hpp"
#include "provis/view.hpp"

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

/// Members right, up, forward and window.
inline Frame frame(const Json& f) {
  const Json& w = items(f.at("window"), 4);
  return {vec3(f.at("right")),
          vec3(f.at("up")),
          vec3(f.at("forward")),
          {number(w[0]), number(w[1]), number(w[2]), number(w[3])}};
}

/// The same, and no other members.
inline Frame checked_frame(const Json& f) {
  check_members(f, {"right", "up", "forward", "window"});
  return frame(f);
}

/// One case of each JSON file of the folder, by name: make(name, file). What is wrong names the file.
template <class Make>
auto load(const std::filesystem::path& folder, const Make& make) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end(),
            [](const auto& a, const auto& b) { return a.stem().string() < b.stem().string(); });
  std::vector<decltype(make(std::string(), Json()))> cases;
  for (const std::filesystem::path& file : files) {
    try {
      std::ifstream in(file);
      cases.push_back(make(file.stem().string(), Json::parse(in)));
    } catch (const std::exception& e) {
      throw std::runtime_error(file.string() + ": " + e.what());
    }
  }
  return cases;
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
