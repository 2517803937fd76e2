#include "src/scene/gltf_primitive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/gltf_fault.hpp"
#include "src/scene/gltf_reduce.hpp"

namespace provis {
namespace {

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
  check_usable(m.extras);
  unsigned flags = 0;
  if (!m.doubleSided) flags |= single_sided;
  if (lets_light_through(m)) flags |= see_through;
  return static_cast<std::uint8_t>(flags);
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
      fail_invalid(place, fmt::format("{}: element {} is vertex {} of {}", accessors.place_of(indices), i,
                                      corners[i], vertices));
  return corners;
}

/// One per vertex; empty if the file has none.
std::vector<double> radii_of(const tinygltf::Primitive& primitive, std::size_t vertices,
                             AccessorReader& accessors, const std::string& place) {
  constexpr ElementKind kind = {"radii", TINYGLTF_TYPE_SCALAR, any_component};
  const int accessor = attribute(primitive, radius_attribute);
  if (accessor < 0) return {};
  std::vector<double> radii =
      accessors.numbers(accessor, kind, fmt::format("{}.attributes.{}", place, radius_attribute));
  const std::string accessor_place = accessors.place_of(accessor);
  if (radii.size() != vertices)
    fail_invalid(accessor_place, fmt::format("{} radii for {} vertices", radii.size(), vertices));
  const auto negative = std::ranges::find_if(radii, [](double r) { return r < 0; });
  if (negative != radii.end())
    fail_invalid(accessor_place,
                 fmt::format("element {}, a radius, is {}", negative - radii.begin(), *negative));
  return radii;
}

Shape shape_of(int mode, bool points_are_spheres) {
  if (mode >= TINYGLTF_MODE_TRIANGLES) return Shape::triangles;
  return mode == TINYGLTF_MODE_POINTS && points_are_spheres ? Shape::spheres : Shape::nothing;
}

std::vector<Triangle> triangles_of(int mode, const Corners& corners, const std::string& place) {
  if (mode == TINYGLTF_MODE_TRIANGLES) return separate_triangles(corners, place);
  return mode == TINYGLTF_MODE_TRIANGLE_STRIP ? strip_triangles(corners) : fan_triangles(corners);
}

}  // namespace

int attribute(const tinygltf::Primitive& primitive, const std::string& name) {
  const auto found = primitive.attributes.find(name);
  return found == primitive.attributes.end() ? -1 : found->second;
}

DecodedPrimitive decode_primitive(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                  AccessorReader& accessors, const std::string& place,
                                  bool points_are_spheres) {
  DecodedPrimitive decoded;
  if (primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    fail_invalid(place + ".mode", fmt::format("unknown mode {}", primitive.mode));
  const int positions = attribute(primitive, "POSITION"), indices = attribute(primitive, indices_attribute);
  if (positions < 0) return decoded;

  decoded.flags = flags_of(model, primitive.material, place + ".material");
  const std::size_t vertices = accessors.positions(positions, place + ".attributes.POSITION").size();
  Corners corners = corners_of(indices, vertices, accessors, place);
  if (primitive.mode == TINYGLTF_MODE_POINTS) decoded.radii = radii_of(primitive, vertices, accessors, place);
  decoded.shape = shape_of(primitive.mode, points_are_spheres || !decoded.radii.empty());
  if (decoded.shape == Shape::nothing) {
    decoded.skipped = skipped(primitive.mode, corners.size());
    return decoded;
  }
  decoded.positions = positions;
  if (decoded.shape == Shape::spheres)
    decoded.points = std::move(corners);
  else
    decoded.triangles = triangles_of(primitive.mode, corners, place);
  return decoded;
}

}  // namespace provis
