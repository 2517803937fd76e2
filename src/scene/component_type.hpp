#pragma once
// The C++ types of glTF's component types.

#include <cstddef>
#include <cstdint>

#include "src/scene/gltf_model.hpp"

namespace provis {

/// Calls use with a value of the component's C++ type.
template <class Use>
void with_component_type(int component_type, const Use& use) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return use(std::int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return use(std::uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return use(std::int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return use(std::uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_INT:
      return use(std::int32_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return use(std::uint32_t{});
    default:
      return use(float{});
  }
}

inline std::size_t component_size(int component_type) {
  std::size_t size = 0;
  with_component_type(component_type, [&size](auto zero) { size = sizeof(zero); });
  return size;
}

inline std::size_t component_count(const tinygltf::Accessor& accessor) {
  return static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
}

}  // namespace provis
