#include "src/scene/gltf_draco.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "src/scene/component_type.hpp"
#include "src/scene/failure.hpp"
#include "src/scene/gltf_reduce.hpp"

namespace provis {
namespace {

constexpr std::uint64_t no_attribute = std::numeric_limits<std::uint64_t>::max();

const tinygltf::Value& extension_of(const tinygltf::Primitive& primitive) {
  return primitive.extensions.at(draco_extension);
}

/// Whether the extension stands for that attribute; for indices it always does.
bool stands_for(const tinygltf::Primitive& primitive, const std::string& name) {
  return name == indices_attribute || extension_of(primitive).Get("attributes").Has(name);
}

/// Whether a number of type T has exactly that value.
template <class T>
bool holds(double number) {
  if (std::is_floating_point_v<T> && !(std::abs(number) <= std::numeric_limits<T>::max())) return false;
  if (std::is_integral_v<T> && !(number >= static_cast<double>(std::numeric_limits<T>::min()) &&
                                 number <= static_cast<double>(std::numeric_limits<T>::max())))
    return false;
  return static_cast<double>(static_cast<T>(number)) == number;
}

/// The numbers as the accessor declares them.
Bytes packed(const std::vector<double>& numbers, int component_type, std::size_t components,
             const std::string& place) {
  Bytes bytes;
  with_component_type(component_type, [&](auto zero) {
    using T = decltype(zero);
    bytes.resize(numbers.size() * sizeof(T));
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      if (!holds<T>(numbers[i]))
        fail_invalid(place,
                     fmt::format("element {} is {} in the Draco data, which component type {} does not hold",
                                 i / components, numbers[i], component_type));
      const T value = static_cast<T>(numbers[i]);
      std::memcpy(bytes.data() + i * sizeof(T), &value, sizeof(T));
    }
  });
  return bytes;
}

}  // namespace

void GltfDraco::decompress(tinygltf::Primitive& primitive, const std::string& place) {
  if (primitive.extensions.count(draco_extension) == 0 || primitive.attributes.count("POSITION") == 0 ||
      has_plain_data(primitive, place))
    return;
  const bool strip = primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP;
  if (primitive.mode != TINYGLTF_MODE_TRIANGLES && !strip)
    fail_invalid(place + ".mode",
                 fmt::format("mode {}, which {} does not allow", primitive.mode, draco_extension));
  if (primitive.attributes.count(indices_attribute) == 0)
    fail_invalid(place, fmt::format("no indices, although {} has triangles", draco_extension));
  const int view = extension_of(primitive).Get("bufferView").GetNumberAsInt();
  auto attributes = primitive.attributes;
  for (auto& [name, accessor] : attributes) {
    if (!stands_for(primitive, name)) continue;
    if (name == indices_attribute)
      accessor = supplied_indices(accessor, view, strip, place);
    else
      accessor = supplied_attribute(
          accessor, view,
          static_cast<std::uint64_t>(extension_of(primitive).Get("attributes").Get(name).GetNumberAsDouble()),
          place);
  }
  primitive.attributes = std::move(attributes);
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
}

bool GltfDraco::has_plain_data(const tinygltf::Primitive& primitive, const std::string& place) const {
  for (const auto& [name, accessor] : primitive.attributes)
    if (stands_for(primitive, name) && accessors_.at(accessor, place).bufferView < 0) return false;
  return true;
}

const DracoMesh& GltfDraco::mesh(int view, const std::string& place) {
  const auto found = meshes_.find(view);
  if (found != meshes_.end()) return found->second;
  const ByteSpan compressed = views_.view(view, place).bytes;
  return meshes_.emplace(view, DracoMesh(compressed, budget_, place)).first->second;
}

int GltfDraco::supplied_attribute(int accessor, int view, std::uint64_t id, const std::string& place) {
  const auto found = supplied_.find({accessor, view, id});
  if (found != supplied_.end()) return found->second;
  const tinygltf::Accessor& declared = accessors_.at(accessor, place);
  const DracoMesh& decoded = mesh(view, place);
  const DracoValues values = decoded.attribute(id, place);
  if (declared.count != decoded.point_count() || component_count(declared) != values.components)
    fail_invalid(place, fmt::format("{} has {} elements of {} components, the Draco data {} of {}",
                                    accessors_.place_of(accessor), declared.count, component_count(declared),
                                    decoded.point_count(), values.components));
  if (values.normalized && declared.componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)
    fail_invalid(place, fmt::format("{} has floats, the Draco data normalised integers",
                                    accessors_.place_of(accessor)));
  const int result = supply(accessor, values.numbers, values.components, place);
  supplied_.emplace(std::tuple(accessor, view, id), result);
  return result;
}

/// A strip has other indices than the triangles that it stands for, and nothing says how many.
int GltfDraco::supplied_indices(int accessor, int view, bool count_is_free, const std::string& place) {
  const auto found = supplied_.find({accessor, view, no_attribute});
  if (found != supplied_.end()) return found->second;
  const std::size_t declared = accessors_.at(accessor, place).count;
  const std::size_t triangles = mesh(view, place).triangle_count();
  // Some exporters of 3D Tiles wrote the number of triangles.
  if (!count_is_free && declared != 3 * triangles && declared != triangles)
    fail_invalid(place, fmt::format("{} has {} elements, the Draco data {} triangles",
                                    accessors_.place_of(accessor), declared, triangles));
  const int result = supply(accessor, mesh(view, place).corners(), 1, place);
  supplied_.emplace(std::tuple(accessor, view, no_attribute), result);
  return result;
}

int GltfDraco::supply(int accessor, const std::vector<double>& numbers, std::size_t components,
                      const std::string& place) {
  const int type = accessors_.at(accessor, place).componentType;
  const int view = views_.add(packed(numbers, type, components, accessors_.place_of(accessor)));
  return accessors_.supply(accessor, view, numbers.size() / components, place);
}

}  // namespace provis
