#include "tests/point/named_views.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

namespace provis::test {

std::vector<NamedView> named_views(const std::filesystem::path& scene_file) {
  std::ifstream in(scene_file.parent_path() / "views.json");
  std::vector<NamedView> views;
  const auto vector = [](const nlohmann::json& j) { return Vec3d{j.at(0), j.at(1), j.at(2)}; };
  for (const nlohmann::json& v : nlohmann::json::parse(in)) {
    if (v.at("scene") != scene_file.filename().string()) continue;
    LookAt camera;
    camera.eye = vector(v.at("eye"));
    camera.direction = vector(v.at("dir"));
    camera.up = vector(v.at("up"));
    camera.fovy_degrees = v.at("fovy_deg");
    views.push_back({v.at("name"), look_at(camera)});
  }
  return views;
}

}  // namespace provis::test
