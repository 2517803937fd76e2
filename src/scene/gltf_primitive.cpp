#include "src/scene/gltf_primitive.hpp"

#include <fmt/format.h>

#include <numeric>

#include "src/scene/failure.hpp"
#include "src/scene/gltf_reduce.hpp"

namespace provis {
namespace {

/// The accessor of that attribute, or -1.
int attribute(const tinygltf::Primitive& primitive, const char* name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

bool lets_light_through(const tinygltf::Material& material) {
  if (material.alphaMode != "OPAQUE") return true;
  const auto transmission = material.extensions.find(transmission_extension);
  if (transmission == material.extensions.end() || !transmission->second.Has("transmissionFactor"))
    return false;
  return transmission->second.Get("transmissionFactor").GetNumberAsDouble() != 0;
}

/// Without a material the default one holds: single-sided and opaque.
std::uint8_t flags_of(const tinygltf::Model& model, int material, const std::string& place) {
  if (material < 0) return single_sided;
  if (static_cast<std::size_t>(material) >= model.materials.size())
    fail_invalid(place, fmt::format("material {} of {} does not exist", material, model.materials.size()));
  const tinygltf::Material& m = model.materials[static_cast<std::size_t>(material)];
  unsigned flags = 0;
  if (!m.doubleSided) flags |= single_sided;
  if (lets_light_through(m)) flags |= see_through;
  return static_cast<std::uint8_t>(flags);
}

/// A file may give the same geometry uncompressed beside the extension; only then can it be read.
void check_compression(const tinygltf::Primitive& primitive, AccessorReader& accessors,
                       const std::string& place) {
  if (primitive.extensions.count(draco_extension) == 0) return;
  const auto missing = [&](const char* name) {
    const int accessor = attribute(primitive, name);
    return accessor >= 0 && !accessors.has_data(accessor, place);
  };
  if (missing("POSITION") || missing(indices_attribute))
    fail_unsupported(place, fmt::format("the geometry is in {} only", draco_extension));
}

Skipped points(std::uint64_t count) { return {count, 0}; }
Skipped lines(std::uint64_t count) { return {0, count}; }

/// What a mode without a surface holds.
Skipped skipped(int mode, std::uint64_t elements) {
  switch (mode) {
    case TINYGLTF_MODE_POINTS:
      return points(elements);
    case TINYGLTF_MODE_LINE:
      return lines(elements / 2);
    case TINYGLTF_MODE_LINE_LOOP:
      return lines(elements > 1 ? elements : 0);
    default:
      return lines(elements > 1 ? elements - 1 : 0);
  }
}

using Corners = std::vector<std::uint32_t>;

std::vector<Triangle> separate_triangles(const Corners& v, const std::string& place) {
  if (v.size() % 3 != 0)
    fail_invalid(place, fmt::format("{} corners are no whole number of triangles", v.size()));
  std::vector<Triangle> triangles(v.size() / 3);
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
  return triangles;
}

std::vector<Triangle> strip_triangles(const Corners& v) {
  std::vector<Triangle> triangles(v.size() < 3 ? 0 : v.size() - 2);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    triangles[i] = {v[i], v[i + 1 + i % 2], v[i + 2 - i % 2]};
  return triangles;
}

std::vector<Triangle> fan_triangles(const Corners& v) {
  std::vector<Triangle> triangles(v.size() < 3 ? 0 : v.size() - 2);
  for (std::size_t i = 0; i < triangles.size(); ++i) triangles[i] = {v[i + 1], v[i + 2], v[0]};
  return triangles;
}

Corners corners_of(int indices, std::size_t vertices, AccessorReader& accessors, const std::string& place) {
  if (indices < 0) {
    Corners all(vertices);
    std::iota(all.begin(), all.end(), 0u);
    return all;
  }
  Corners corners = accessors.indices(indices, place + ".indices");
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (corners[i] >= vertices)
      fail_invalid(place, fmt::format("accessors[{}]: element {} is vertex {} of {}", indices, i, corners[i],
                                      vertices));
  return corners;
}

}  // namespace

DecodedPrimitive decode_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                  AccessorReader& accessors, const std::string& place) {
  DecodedPrimitive decoded;
  if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    fail_invalid(place + ".mode", fmt::format("unknown mode {}", primitive.mode));
  check_compression(primitive, accessors, place);
  const int positions = attribute(primitive, "POSITION"), indices = attribute(primitive, indices_attribute);
  if (positions < 0) return decoded;

  decoded.flags = flags_of(model, primitive.material, place + ".material");
  const std::size_t vertices = accessors.positions(positions, place + ".attributes.POSITION").size();
  const Corners corners = corners_of(indices, vertices, accessors, place);
  if (primitive.mode < TINYGLTF_MODE_TRIANGLES) {
    decoded.skipped = skipped(primitive.mode, corners.size());
    return decoded;
  }
  decoded.positions = positions;
  if (primitive.mode == TINYGLTF_MODE_TRIANGLES)
    decoded.triangles = separate_triangles(corners, place);
  else
    decoded.triangles =
        primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ? strip_triangles(corners) : fan_triangles(corners);
  return decoded;
}

}  // namespace provis
