#include "src/report/source_report.hpp"

#include <fmt/format.h>

#include <iterator>

#include "src/report/json_text.hpp"
#include "src/report/names.hpp"

namespace provis {

namespace {

using Json = nlohmann::ordered_json;

std::string text(const Vec3d& v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }

Json json(const Vec3d& v) { return {v.x, v.y, v.z}; }

bool is_triangle(const Scene& scene, PrimitiveId id) { return id < scene.triangles().size(); }

std::uint8_t flags_of(const Scene& scene, PrimitiveId id) {
  return is_triangle(scene, id) ? scene.triangle_flags()[id]
                                : scene.sphere_flags()[id - scene.triangles().size()];
}

/// The name of the node, or of the PLY element; empty where there is none.
std::string name_at(std::span<const std::string> names, std::int32_t index) {
  return index >= 0 && static_cast<std::size_t>(index) < names.size() ? names[static_cast<std::size_t>(index)]
                                                                      : std::string();
}

std::string place_text(const Scene& scene, const PrimitiveSource& source) {
  std::string lines;
  auto out = std::back_inserter(lines);
  if (source.node < 0) {
    fmt::format_to(out, "element    {} {}\n", name_at(scene.notes().elements, source.primitive),
                   source.element);
  } else {
    fmt::format_to(out, "node       {}{}\n", source.node,
                   quoted_name(name_at(scene.node_names(), source.node)));
    if (source.instance >= 0) fmt::format_to(out, "instance   {}\n", source.instance);
    fmt::format_to(out, "mesh       {}\nprimitive  {}\nelement    {}\n", source.mesh, source.primitive,
                   source.element);
  }
  if (source.parts > 1) fmt::format_to(out, "part       {} of {}\n", source.part, source.parts);
  return lines;
}

std::string shape_text(const Scene& scene, PrimitiveId id) {
  std::string lines;
  auto out = std::back_inserter(lines);
  if (is_triangle(scene, id)) {
    for (int k = 0; k < 3; ++k) fmt::format_to(out, "corner {}   {}\n", k, text(scene.corner(id, k)));
  } else {
    const Sphere& sphere = scene.spheres()[id - scene.triangles().size()];
    fmt::format_to(out, "centre     {}\nradius     {}\n", text(sphere.center), sphere.radius);
  }
  return lines;
}

void add_place(Json& root, const Scene& scene, const PrimitiveSource& source) {
  const bool ply = source.node < 0;
  root["node"] = index_json(source.node);
  root["node_name"] = ply ? Json() : Json(name_at(scene.node_names(), source.node));
  root["instance"] = index_json(source.instance);
  root["mesh"] = index_json(source.mesh);
  root["primitive"] = ply ? Json() : Json(source.primitive);
  root["element_name"] = ply ? Json(name_at(scene.notes().elements, source.primitive)) : Json();
  root["element"] = source.element;
  root["part"] = source.part;
  root["parts"] = source.parts;
}

void add_shape(Json& root, const Scene& scene, PrimitiveId id) {
  if (is_triangle(scene, id)) {
    root["corners"] = {json(scene.corner(id, 0)), json(scene.corner(id, 1)), json(scene.corner(id, 2))};
  } else {
    const Sphere& sphere = scene.spheres()[id - scene.triangles().size()];
    root["center"] = json(sphere.center);
    root["radius"] = sphere.radius;
  }
}

}  // namespace

std::string source_text(const std::string& file, const Scene& scene, PrimitiveId id) {
  const auto source = source_of(scene, id);
  return fmt::format("id         {} ({})\n", id, is_triangle(scene, id) ? "triangle" : "sphere") +
         fmt::format("file       {}\n", file) + (source ? place_text(scene, *source) : "") +
         fmt::format("material   {}\n", flags_text(flags_of(scene, id))) + shape_text(scene, id);
}

std::string source_json(const std::string& file, const Scene& scene, PrimitiveId id) {
  const auto source = source_of(scene, id);
  const std::uint8_t flags = flags_of(scene, id);
  Json root = {{"format", "provis.primitive-source"},
               {"version", 1},
               {"file", file},
               {"hash", scene.hash()},
               {"id", id},
               {"kind", is_triangle(scene, id) ? "triangle" : "sphere"}};
  if (source) add_place(root, scene, *source);
  root["single_sided"] = (flags & single_sided) != 0;
  root["see_through"] = (flags & see_through) != 0;
  add_shape(root, scene, id);
  return json_text(root) + "\n";
}

std::string node_ids_text(const std::vector<IdRange>& ranges) {
  std::string lines;
  for (const auto& [first, last] : ranges) fmt::format_to(std::back_inserter(lines), "{}-{}\n", first, last);
  return lines;
}

std::string node_ids_json(const std::string& file, const Scene& scene, const std::vector<int>& nodes) {
  Json root = {{"format", "provis.node-ids"}, {"version", 1}, {"file", file}, {"hash", scene.hash()}};
  root["nodes"] = nodes;
  root["ranges"] = Json::array();
  for (const auto& [first, last] : ids_of_nodes(scene, nodes))
    root["ranges"].push_back(Json::array({first, last}));
  return json_text(root) + "\n";
}

}  // namespace provis
