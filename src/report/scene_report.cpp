#include "src/report/scene_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "src/report/json_text.hpp"
#include "src/report/names.hpp"
#include "src/report/summary.hpp"

namespace provis {

namespace {

using Out = std::back_insert_iterator<std::string>;

std::string text(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

void add_file(Out out, const FileNotes& notes) {
  if (!notes.format.empty()) {
    fmt::format_to(out, "format     {}, unit {}\n", notes.format,
                   notes.unit.empty() ? "unknown" : notes.unit);
  }
  if (notes.scene >= 0 && static_cast<std::size_t>(notes.scene) < notes.scenes.size()) {
    const std::string& name = notes.scenes[static_cast<std::size_t>(notes.scene)];
    fmt::format_to(out, "loaded     scene {}{} of {}\n", notes.scene, quoted_name(name), notes.scenes.size());
  }
  for (const AnimationInfo& animation : notes.animations) {
    fmt::format_to(out, "animation  {}{}, {} to {} s, {}\n", animation.index, quoted_name(animation.name),
                   animation.first, animation.last,
                   animation.index == notes.animation ? "applied" : "not applied");
  }
  const bool listed =
      std::ranges::find(notes.animations, notes.animation, &AnimationInfo::index) != notes.animations.end();
  if (notes.animation >= 0 && !listed) fmt::format_to(out, "animation  {}, applied\n", notes.animation);
}

void add_counts(Out out, const SceneInfo& info) {
  const SceneSummary& s = info.counts;
  fmt::format_to(out, "triangles  {} ({} of zero area, {} duplicates)\n", s.triangles, s.degenerate_triangles,
                 info.topology.duplicate_triangles);
  fmt::format_to(out, "edges      {} ({} open)\n", info.topology.edges, info.topology.open_edges);
  fmt::format_to(out, "spheres    {} ({} of radius 0)", s.spheres, s.degenerate_spheres);
  if (s.spheres > 0) fmt::format_to(out, ", radius {} to {}", s.smallest_radius, s.largest_radius);
  fmt::format_to(out, "\nvertices   {}\n", s.vertices);
  fmt::format_to(out, "extent     {} to {}\n", text(s.lower), text(s.upper));
  for (std::size_t flags = 0; flags < s.triangles_by_flags.size(); ++flags) {
    const std::size_t triangles = s.triangles_by_flags[flags], spheres = s.spheres_by_flags[flags];
    if (triangles + spheres == 0) continue;
    fmt::format_to(out, "material   {:<27}{} triangles, {} spheres\n",
                   flags_text(static_cast<std::uint8_t>(flags)), triangles, spheres);
  }
}

/// How many runs of ids, and from how many nodes.
void add_sources(Out out, const Scene& scene) {
  std::vector<std::int32_t> nodes;
  for (const SourceRange& run : scene.sources()) {
    if (run.node >= 0) nodes.push_back(run.node);
  }
  std::ranges::sort(nodes);
  const auto different = std::unique(nodes.begin(), nodes.end()) - nodes.begin();
  const std::string from = nodes.empty() ? "" : fmt::format(" from {} nodes", different);
  fmt::format_to(out, "sources    {} runs of ids{}\n", scene.sources().size(), from);
}

void add_left_out(Out out, std::span<const LeftOut> left_out) {
  constexpr std::size_t shown = 10;
  if (left_out.empty()) return;
  fmt::format_to(out, "left out   {} invalid primitives\n", left_out.size());
  for (const LeftOut& item : left_out.first(std::min(shown, left_out.size()))) {
    fmt::format_to(out, "           {}: {}\n", item.place, item.reason);
  }
  if (left_out.size() > shown) {
    fmt::format_to(out, "           and {} more; --json lists them all\n", left_out.size() - shown);
  }
}

void add_cost(Out out, const Scene& scene, const LoadCost& cost) {
  fmt::format_to(out, "load       {:.3f} s, ", cost.seconds);
  if (!scene.triangles().empty()) {
    fmt::format_to(out, "{:.1f} bytes per triangle, ",
                   static_cast<double>(array_bytes(scene)) / static_cast<double>(scene.triangles().size()));
  }
  fmt::format_to(out, "peak memory {:.1f} MiB\n", static_cast<double>(cost.peak_resident_bytes) / (1 << 20));
}

}  // namespace

std::string effects_text(const EffectsPlan& plan) {
  std::string text;
  for (const EffectNeed& need : plan.needs) {
    fmt::format_to(std::back_inserter(text), "effect     {:<14}{:<10}{}\n", name(need.effect),
                   need.needed ? "needed" : "left out", need.reason);
  }
  return text;
}

std::string scene_text(const Scene& scene, const SceneInfo& info) {
  std::string lines;
  const Out out(lines);
  fmt::format_to(out, "scene      {}\n", info.file);
  fmt::format_to(out, "hash       {}\n", scene.hash());
  fmt::format_to(out, "options    {}\n", options_text(info.options));
  add_file(out, scene.notes());
  add_counts(out, info);
  add_sources(out, scene);
  fmt::format_to(out, "skipped    {} points, {} lines\n", scene.skipped().points, scene.skipped().lines);
  add_left_out(out, scene.left_out());
  lines += effects_text(info.effects);
  add_cost(out, scene, info.cost);
  return lines;
}

}  // namespace provis
