// "provis.scene-info": the same in every run but for "stats".

#include <ostream>

#include "src/report/json_text.hpp"
#include "src/report/scene_report.hpp"

namespace provis {

namespace {

using Json = nlohmann::ordered_json;

Json json(const Vec3d& v) { return {v.x, v.y, v.z}; }

Json json(const SourceRange& run) {
  return {{"first", run.first},
          {"last", run.first + run.count - 1},
          {"node", index_json(run.node)},
          {"mesh", index_json(run.mesh)},
          {"primitive", index_json(run.primitive)},
          {"instance", index_json(run.instance)},
          {"element", run.element},
          {"per_element", run.per_element}};
}

Json scene_member(const Scene& scene, const SceneInfo& info) {
  return {{"file", info.file},
          {"hash", scene.hash()},
          {"triangles", info.counts.triangles},
          {"spheres", info.counts.spheres},
          {"left_out", left_out_json(scene.left_out())}};
}

Json materials(const std::array<std::size_t, 4>& by_flags) {
  return {{"two_sided_opaque", by_flags[0]},
          {"single_sided_opaque", by_flags[single_sided]},
          {"two_sided_see_through", by_flags[see_through]},
          {"single_sided_see_through", by_flags[single_sided | see_through]}};
}

Json scenes(const FileNotes& notes) {
  Json list = Json::array();
  for (std::size_t i = 0; i < notes.scenes.size(); ++i)
    list.push_back({{"index", i}, {"name", notes.scenes[i]}, {"loaded", static_cast<int>(i) == notes.scene}});
  return list;
}

Json animations(const FileNotes& notes) {
  Json list = Json::array();
  for (const AnimationInfo& animation : notes.animations)
    list.push_back({{"index", animation.index},
                    {"name", animation.name},
                    {"first", animation.first},
                    {"last", animation.last},
                    {"applied", animation.index == notes.animation}});
  return list;
}

Json effects(const EffectsPlan& plan) {
  Json list = Json::array();
  for (const EffectNeed& need : plan.needs)
    list.push_back({{"effect", name(need.effect)}, {"needed", need.needed}, {"reason", need.reason}});
  return list;
}

Json stats(const Scene& scene, const LoadCost& cost) {
  const std::size_t bytes = array_bytes(scene), triangles = scene.triangles().size();
  Json per_triangle;
  if (triangles > 0) per_triangle = static_cast<double>(bytes) / static_cast<double>(triangles);
  return {{"load_seconds", cost.seconds},
          {"array_bytes", bytes},
          {"bytes_per_triangle", per_triangle},
          {"peak_resident_bytes", cost.peak_resident_bytes}};
}

Json members(const Scene& scene, const SceneInfo& info) {
  const SceneSummary& s = info.counts;
  const FileNotes& notes = scene.notes();
  Json root = {{"scene", scene_member(scene, info)}, {"options", Json(info.options)}};
  root["file_format"] = notes.format;
  root["unit"] = notes.unit.empty() ? Json() : Json(notes.unit);
  root["scenes"] = scenes(notes);
  root["animations"] = animations(notes);
  root["applied_animation"] = index_json(notes.animation);
  root["elements"] = notes.elements;
  root["vertices"] = s.vertices;
  root["degenerate"] = {{"triangles", s.degenerate_triangles}, {"spheres", s.degenerate_spheres}};
  root["duplicate_triangles"] = info.topology.duplicate_triangles;
  root["edges"] = {{"total", info.topology.edges}, {"open", info.topology.open_edges}};
  root["radius"] =
      s.spheres > 0 ? Json{{"smallest", s.smallest_radius}, {"largest", s.largest_radius}} : Json();
  root["extent"] = {{"lower", json(s.lower)}, {"upper", json(s.upper)}};
  root["flags"] = {{"single_sided", s.single_sided}, {"see_through", s.see_through}};
  root["materials"] = {{"triangles", materials(s.triangles_by_flags)},
                       {"spheres", materials(s.spheres_by_flags)}};
  root["skipped"] = {{"points", scene.skipped().points}, {"lines", scene.skipped().lines}};
  root["effects"] = effects(info.effects);
  root["stats"] = stats(scene, info.cost);
  return root;
}

}  // namespace

void write_scene_json(const Scene& scene, const SceneInfo& info, std::ostream& out) {
  out << "{\"format\": \"provis.scene-info\",\n\"version\": 1";
  const Json all = members(scene, info);
  for (const auto& [key, value] : all.items()) out << ",\n\"" << key << "\": " << json_text(value);
  out << ",\n\"sources\": [";
  const char* separator = "\n";
  for (const SourceRange& run : scene.sources()) {
    if (run.count == 0) continue;
    out << separator << json_text(json(run));
    separator = ",\n";
  }
  out << "]}\n";
}

}  // namespace provis
