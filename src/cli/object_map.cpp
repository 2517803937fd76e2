#include "src/cli/object_map.hpp"

#include <fmt/format.h>

#include <limits>

#include "provis/error.hpp"
#include "src/report/json_node.hpp"

namespace provis {

namespace {

PrimitiveId id(const JsonNode& node) {
  const std::uint64_t n = node.natural();
  if (n >= std::numeric_limits<PrimitiveId>::max()) node.fail("is too large for an id");
  return static_cast<PrimitiveId>(n);
}

std::vector<IdRange> node_ids(const JsonNode& node, const DetailScene& scene) {
  try {
    const std::vector<IdRange> ranges = ids_of_nodes(*scene.scene, nodes_called(*scene.scene, node.text()));
    if (!ranges.empty()) return ranges;
  } catch (const Error& error) {
    node.fail(fmt::format("in {}: {}", scene.file, error.what()));
  }
  node.fail(fmt::format("in {}: node \"{}\" holds no primitives of its own", scene.file, node.text()));
}

std::vector<IdRange> ids(const JsonNode& object, const char* key, const DetailScene& scene) {
  std::vector<IdRange> all;
  if (!object.has(key)) return all;
  for (const JsonNode& item : object.member(key).items()) {
    if (item.raw().is_string()) {
      for (const IdRange& range : node_ids(item, scene)) all.push_back(range);
      continue;
    }
    const std::vector<JsonNode> ends = item.items(2);
    all.push_back({id(ends[0]), id(ends[1])});
  }
  return all;
}

}  // namespace

std::vector<DetailObject> read_object_map(const std::string& file, const DetailScene& full,
                                          const DetailScene& occluders, const DetailScene& shell) {
  const nlohmann::json json = parse_json_file(file);
  const JsonNode root(json, file);
  if (root.member("format").text() != "provis.objects")
    root.member("format").fail("is not \"provis.objects\"");
  if (root.member("version").natural() != 1) root.member("version").fail("is not 1");
  std::vector<DetailObject> objects;
  for (const JsonNode& item : root.member("objects").items()) {
    for (const auto& [key, value] : item.raw().items())
      if (key != "name" && key != "full" && key != "occluders" && key != "shell")
        item.fail(fmt::format("has a member \"{}\", which is none of name, full, occluders, shell", key));
    objects.push_back({item.member("name").text(), ids(item, "full", full), ids(item, "occluders", occluders),
                       ids(item, "shell", shell)});
  }
  return objects;
}

}  // namespace provis
