#include "src/scene/reduce_compression.hpp"

#include <nlohmann/json.hpp>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

using enum JsonKind;

constexpr JsonMember meshopt_members[] = {{"buffer", index, true},
                                          {"byteOffset", count},
                                          {"byteLength", count, true},
                                          {"byteStride", count, true},
                                          {"count", count, true},
                                          {"mode", text, true},
                                          {"filter", text}};
constexpr JsonMember draco_members[] = {{"bufferView", index, true}};

/// tinygltf cuts the integers of extensions down to 32 bits; written as floating-point numbers they stay
/// whole.
Json with_doubles(Json object) {
  for (Json& value : object)
    if (value.is_number()) value = value.get<double>();
  return object;
}

}  // namespace

Json reduced_meshopt(const Json& extension, const std::string& place) {
  return with_doubles(checked_members(extension, place, meshopt_members));
}

Json reduced_draco(const Json& extension, const Json& kept_attributes, const std::string& place) {
  Json reduced = checked_members(extension, place, draco_members);
  const Json* ids = find_member(extension, "attributes");
  if (ids == nullptr) fail_invalid(place, "attributes is missing");
  require_object(*ids, place + ".attributes");
  Json& kept = reduced["attributes"] = Json::object();
  for (const auto& [name, accessor] : kept_attributes.items()) {
    const JsonMember member[] = {{name.c_str(), count}};
    kept.update(with_doubles(checked_members(*ids, place + ".attributes", member)));
  }
  if (ids->contains("POSITION") && !kept.contains("POSITION"))
    fail_invalid(place + ".attributes", "POSITION, which the primitive's own attributes do not have");
  return reduced;
}

}  // namespace provis
