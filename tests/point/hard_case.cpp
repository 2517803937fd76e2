#include "tests/point/hard_case.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>

namespace provis::test {

namespace {

using Json = nlohmann::json;

/// A misspelt member would otherwise go unread, and what it says untested.
void check_members(const Json& object, const std::set<std::string>& known) {
  for (const auto& [key, value] : object.items()) {
    if (known.count(key) == 0) throw std::runtime_error("unknown member '" + key + "'");
  }
}

double number(const Json& value) {
  if (!value.is_number()) throw std::runtime_error(value.dump() + " is no number");
  return value.get<double>();
}

/// get<std::uint32_t>() would take -1 and 1.5 as well.
std::uint32_t index(const Json& value, std::size_t count) {
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count) {
    throw std::runtime_error(value.dump() + " is no index below " + std::to_string(count));
  }
  return value.get<std::uint32_t>();
}

const Json& items(const Json& value, std::size_t count) {
  if (!value.is_array() || value.size() != count) {
    throw std::runtime_error(value.dump() + " is no list of " + std::to_string(count));
  }
  return value;
}

Vec3d vec3(const Json& value) {
  const Json& v = items(value, 3);
  return {number(v[0]), number(v[1]), number(v[2])};
}

std::vector<PrimitiveId> ids(const Json& value, std::size_t count) {
  std::vector<PrimitiveId> list;
  for (const Json& id : items(value, value.size())) list.push_back(index(id, count));
  if (std::adjacent_find(list.begin(), list.end(), std::greater_equal<>()) != list.end()) {
    throw std::runtime_error(value.dump() + " is not ascending");
  }
  return list;
}

SceneArrays scene(const Json& file) {
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

PointView view(const Json& query) {
  check_members(query, {"kind", "projection", "eye", "right", "up", "forward", "window"});
  if (query.at("kind") != "point") throw std::runtime_error("the query's kind is not 'point'");
  const std::string projection = query.at("projection");
  const Vec3d eye = vec3(query.at("eye"));
  if (projection == "omni") return omni(eye);
  if (projection != "pinhole" && projection != "parallel") {
    throw std::runtime_error("'" + projection + "' is no projection");
  }
  const Json& w = items(query.at("window"), 4);
  const Frame frame{vec3(query.at("right")),
                    vec3(query.at("up")),
                    vec3(query.at("forward")),
                    {number(w[0]), number(w[1]), number(w[2]), number(w[3])}};
  return {eye, projection == "pinhole" ? Projection::pinhole : Projection::parallel, {frame}};
}

HardCase hard_case(const std::string& name, const Json& file) {
  check_members(file, {"why", "because", "vertices", "triangles", "flags", "query", "visible",
                       "eye_on_primitive", "doubles", "without_mpfr"});
  HardCase c;
  c.why = file.at("why");
  c.because = file.at("because");
  c.input = {name, 0, scene(file), view(file.at("query"))};
  const std::size_t count = c.input.arrays.triangles.size();
  c.visible = ids(file.at("visible"), count);
  c.eye_on_primitive = file.at("eye_on_primitive").get<bool>();
  if (file.contains("doubles")) c.doubles = ids(file["doubles"], count);
  c.without_mpfr = file.value("without_mpfr", "");
  return c;
}

/// "0-3, 7"; "none" for an empty set.
std::string text(const std::vector<PrimitiveId>& list) {
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

}  // namespace

std::vector<HardCase> load_hard_cases(const std::filesystem::path& folder) {
  std::vector<HardCase> cases;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;
    try {
      std::ifstream in(entry.path());
      cases.push_back(hard_case(entry.path().stem().string(), Json::parse(in)));
    } catch (const std::exception& e) {
      throw std::runtime_error(entry.path().string() + ": " + e.what());
    }
  }
  std::sort(cases.begin(), cases.end(),
            [](const HardCase& a, const HardCase& b) { return a.input.name < b.input.name; });
  return cases;
}

std::string hard_table(const std::vector<HardCase>& cases) {
  std::string table =
      "| case | why it is hard | triangles | visible | doubles only |\n"
      "| --- | --- | ---: | --- | --- |\n";
  for (const HardCase& c : cases) {
    const std::string flag = c.eye_on_primitive ? " (eye on primitive)" : "";
    table += "| [" + c.input.name + "](" + c.input.name + ".json) | " + c.why + " | " +
             std::to_string(c.input.arrays.triangles.size()) + " | " + text(c.visible) + flag + " | " +
             (c.doubles ? "**" + text(*c.doubles) + "**" : "") + " |\n";
  }
  return table;
}

}  // namespace provis::test
