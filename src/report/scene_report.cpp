#include "src/report/scene_report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>

namespace provis {

namespace {

std::string text(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

nlohmann::ordered_json json(const Vec3d& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::string effects_text(const EffectsPlan& plan) {
  std::string text;
  for (const EffectNeed& need : plan.needs) {
    fmt::format_to(std::back_inserter(text), "effect     {:<14}{:<10}{}\n", name(need.effect),
                   need.needed ? "needed" : "left out", need.reason);
  }
  return text;
}

std::string scene_text(const std::string& file, const Scene& scene, const EffectsPlan& plan) {
  const SceneSummary s = summarize(scene);
  std::string lines;
  auto out = std::back_inserter(lines);
  fmt::format_to(out, "scene      {}\n", file);
  fmt::format_to(out, "hash       {}\n", scene.hash());
  fmt::format_to(out, "triangles  {} ({} of zero area)\n", s.triangles, s.degenerate_triangles);
  fmt::format_to(out, "spheres    {} ({} of radius 0)\n", s.spheres, s.degenerate_spheres);
  fmt::format_to(out, "vertices   {}\n", s.vertices);
  fmt::format_to(out, "extent     {} to {}\n", text(s.lower), text(s.upper));
  fmt::format_to(out, "flags      {} single-sided, {} see-through\n", s.single_sided, s.see_through);
  fmt::format_to(out, "skipped    {} points, {} lines\n", scene.skipped().points, scene.skipped().lines);
  return lines + effects_text(plan);
}

std::string scene_json(const std::string& file, const Scene& scene, const EffectsPlan& plan) {
  const SceneSummary s = summarize(scene);
  nlohmann::ordered_json root = {
      {"format", "provis.scene-info"},
      {"version", 1},
      {"scene", {{"file", file}, {"hash", scene.hash()}, {"triangles", s.triangles}, {"spheres", s.spheres}}},
      {"vertices", s.vertices},
      {"degenerate", {{"triangles", s.degenerate_triangles}, {"spheres", s.degenerate_spheres}}},
      {"extent", {{"lower", json(s.lower)}, {"upper", json(s.upper)}}},
      {"flags", {{"single_sided", s.single_sided}, {"see_through", s.see_through}}},
      {"skipped", {{"points", scene.skipped().points}, {"lines", scene.skipped().lines}}}};
  root["effects"] = nlohmann::ordered_json::array();
  for (const EffectNeed& need : plan.needs) {
    root["effects"].push_back(nlohmann::ordered_json{
        {"effect", name(need.effect)}, {"needed", need.needed}, {"reason", need.reason}});
  }
  return root.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace provis
