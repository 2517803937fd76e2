#include "src/scene/gltf_document.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "src/scene/failure.hpp"
#include "src/scene/glb_container.hpp"
#include "src/scene/gltf_reduce.hpp"

namespace provis {
namespace {

/// nlohmann's text begins with "[json.exception.parse_error.101] "; its offset becomes our place.
std::string without_tag(const std::string& message) {
  const std::size_t end = message.find("] ");
  return end == std::string::npos ? message : message.substr(end + 2);
}

/// The place of a number that no float64 holds; nlohmann's text quotes it.
std::string place_of_overflow(std::string_view text, std::string_view message) {
  const std::size_t first = message.find('\'') + 1, last = message.rfind('\'');
  return fmt::format("JSON byte {}", text.find(message.substr(first, last - first)) + 1);
}

/// Bytes of JSON text; the zeros with which some exporters pad a GLB's chunk are left out.
Json parsed(std::string_view text) {
  while (!text.empty() && text.back() == '\0') text.remove_suffix(1);
  try {
    return Json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    fail_invalid(fmt::format("JSON byte {}", error.byte), without_tag(error.what()));
  } catch (const nlohmann::json::out_of_range& error) {
    fail_invalid(place_of_overflow(text, error.what()), without_tag(error.what()));
  } catch (const nlohmann::json::exception& error) {
    fail_invalid("JSON", without_tag(error.what()));
  }
}

std::string dumped(const Json& document) {
  try {
    return document.dump();
  } catch (const nlohmann::json::exception& error) {  // a name that is no UTF-8
    fail_invalid("JSON", without_tag(error.what()));
  }
}

void check_mesh(const Json& reduced, const tinygltf::Mesh& mesh, const std::string& place) {
  const Json& primitives = reduced["primitives"];
  if (mesh.primitives.size() != primitives.size())
    throw Error(Error::Code::internal, place, "tinygltf dropped a primitive");
  for (std::size_t p = 0; p < primitives.size(); ++p) {
    const tinygltf::Primitive& kept = mesh.primitives[p];
    const Json* targets = find_member(primitives[p], "targets");
    if (kept.attributes.size() != primitives[p]["attributes"].size() ||
        kept.targets.size() != (targets == nullptr ? 0 : targets->size()))
      throw Error(Error::Code::internal, fmt::format("{}.primitives[{}]", place, p),
                  "tinygltf dropped an attribute or a morph target");
  }
}

/// tinygltf leaves out what it cannot read; the reduced document holds nothing of that kind.
void check_nothing_dropped(const Json& reduced, const tinygltf::Model& model) {
  const auto check = [&reduced](const char* name, std::size_t count) {
    const Json* all = find_member(reduced, name);
    const std::size_t expected = all == nullptr ? 0 : all->size();
    if (count != expected)
      throw Error(Error::Code::internal, name, fmt::format("tinygltf kept {} of {}", count, expected));
  };
  check("scenes", model.scenes.size());
  check("nodes", model.nodes.size());
  check("meshes", model.meshes.size());
  check("skins", model.skins.size());
  check("accessors", model.accessors.size());
  check("bufferViews", model.bufferViews.size());
  check("materials", model.materials.size());
  for (std::size_t i = 0; i < model.meshes.size(); ++i)
    check_mesh(reduced["meshes"][i], model.meshes[i], fmt::format("meshes[{}]", i));
  for (std::size_t i = 0; i < model.skins.size(); ++i)
    if (model.skins[i].joints.size() != reduced["skins"][i]["joints"].size())
      throw Error(Error::Code::internal, fmt::format("skins[{}]", i), "tinygltf dropped a joint");
}

}  // namespace

GltfDocument read_gltf(ByteSpan file, const std::filesystem::path& folder, const LoadOptions& options) {
  GlbChunks chunks{{reinterpret_cast<const char*>(file.data()), file.size()}, std::nullopt};
  if (is_glb(file)) chunks = split_glb(file);
  const Json document = parsed(chunks.json);
  const Json reduced = reduced_document(document, options.skip_invalid);
  GltfDocument result{parse_model(dumped(reduced)), GltfBuffers(document, folder, chunks.binary),
                      asked_animation(document, options), animation_notes(document)};
  check_nothing_dropped(reduced, result.model);
  return result;
}

}  // namespace provis
