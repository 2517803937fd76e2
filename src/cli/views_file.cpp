#include "src/cli/views_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "provis/error.hpp"
#include "src/report/json_node.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

std::optional<Vec3d> optional_vec3(const JsonNode& node, const char* key) {
  if (!node.has(key)) return std::nullopt;
  return node.member(key).vec3();
}

ViewRequest request(const JsonNode& node) {
  ViewRequest view;
  if (node.has("projection")) {
    const JsonNode word = node.member("projection");
    const auto projection = projection_named(word.text());
    if (!projection) word.fail("is not pinhole, parallel or omni");
    view.projection = *projection;
  }
  view.eye = node.member("eye").vec3();
  view.dir = optional_vec3(node, "dir");
  view.look_at = optional_vec3(node, "look_at");
  view.right = optional_vec3(node, "right");
  view.up = optional_vec3(node, "up");
  view.forward = optional_vec3(node, "forward");
  if (node.has("window")) view.window = node.member("window").window();
  if (node.has("fovy_deg")) view.fovy_degrees = node.member("fovy_deg").number();
  return view;
}

// The list of views in either format.
std::vector<JsonNode> entries(const JsonNode& root) {
  if (root.raw().is_array()) return root.items();
  if (root.member("format").text() != "provis.views") root.member("format").fail("is not \"provis.views\"");
  if (root.member("version").natural() != 1) root.member("version").fail("is not 1");
  return root.member("views").items();
}

}  // namespace

ViewRequest read_named_view(const std::string& file, const std::string& name, const std::string& scene_file) {
  const nlohmann::json json = parse_json_file(file);
  const std::string scene = std::filesystem::path(scene_file).filename().string();
  std::vector<JsonNode> named, of_scene;
  for (const JsonNode& entry : entries(JsonNode(json, file))) {
    if (entry.member("name").text() != name) continue;
    named.push_back(entry);
    if (entry.has("scene") && entry.member("scene").text() == scene) of_scene.push_back(entry);
  }
  const std::vector<JsonNode>& candidates = named.size() > 1 ? of_scene : named;
  if (candidates.size() == 1) return request(candidates.front());
  const std::string found = named.empty() ? "no view" : fmt::format("{} views", named.size());
  throw Error(Error::Code::usage, "--views",
              fmt::format("{} holds {} named \"{}\", {} of them for {}", file, found, name,
                          of_scene.empty() ? "none" : std::to_string(of_scene.size()), scene));
}

}  // namespace provis
