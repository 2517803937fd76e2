#include "src/scene/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <type_traits>

#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"
#include "src/scene/gltf_reduce.hpp"
#include "src/scene/little_endian.hpp"

namespace provis {
namespace {

std::string place_of(int accessor) { return fmt::format("accessors[{}]", accessor); }

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

std::size_t component_size(int component_type) {
  std::size_t size = 0;
  with_component_type(component_type, [&size](auto zero) { size = sizeof(zero); });
  return size;
}

template <class T>
double coordinate(const std::uint8_t* bytes, bool normalized) {
  const double value = static_cast<double>(from_little_endian<T>(bytes));
  if constexpr (std::is_floating_point_v<T>) return value;
  if (!normalized) return value;
  return std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

template <class T>
Vec3d position(const std::uint8_t* bytes, bool normalized) {
  return {coordinate<T>(bytes, normalized), coordinate<T>(bytes + sizeof(T), normalized),
          coordinate<T>(bytes + 2 * sizeof(T), normalized)};
}

bool is_unsigned(int component_type) {
  return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

void check_unsigned(int component_type, const std::string& place) {
  if (!is_unsigned(component_type))
    fail_invalid(place, fmt::format("indices of component type {}, which is not unsigned", component_type));
}

void check_finite(const std::vector<Vec3d>& points, const std::string& place) {
  const auto bad = std::ranges::find_if_not(points, finite);
  if (bad != points.end())
    fail_invalid(place, fmt::format("element {} is not finite: ({}, {}, {})", bad - points.begin(), bad->x,
                                    bad->y, bad->z));
}

void check_restart(const std::vector<std::uint32_t>& indices, int component_type, const std::string& place) {
  std::uint32_t restart = 0;
  with_component_type(component_type, [&restart](auto zero) {
    restart = static_cast<std::uint32_t>(std::numeric_limits<decltype(zero)>::max());
  });
  const auto found = std::ranges::find(indices, restart);
  if (found != indices.end())
    fail_invalid(place, fmt::format("element {} is {}, the primitive restart value, which glTF forbids",
                                    found - indices.begin(), restart));
}

}  // namespace

bool AccessorReader::has_data(int accessor, const std::string& wanted_by) const {
  const tinygltf::Accessor& a = at(accessor, wanted_by);
  return a.bufferView >= 0 || a.sparse.isSparse;
}

const std::vector<Vec3d>& AccessorReader::positions(int accessor, const std::string& wanted_by) {
  const auto found = positions_.find(accessor);
  if (found != positions_.end()) return found->second;
  return positions_.emplace(accessor, read_positions(at(accessor, wanted_by), place_of(accessor)))
      .first->second;
}

std::vector<Vec3d> AccessorReader::read_positions(const tinygltf::Accessor& a, const std::string& place) {
  if (a.type != TINYGLTF_TYPE_VEC3) fail_invalid(place, "positions that are not of type VEC3");
  const Elements from = base(a, place);
  std::vector<Vec3d> points(a.count);
  with_component_type(a.componentType, [&](auto zero) {
    using T = decltype(zero);
    for (std::size_t i = 0; i < from.count; ++i)
      points[i] = position<T>(from.first + i * from.stride, a.normalized);
    if (!a.sparse.isSparse) return;
    const std::vector<std::uint32_t> targets = sparse_targets(a, place);
    const Elements values = sparse_values(a, 3 * sizeof(T), place);
    for (std::size_t i = 0; i < targets.size(); ++i)
      points[targets[i]] = position<T>(values.first + i * values.stride, a.normalized);
  });
  check_finite(points, place);
  return points;
}

std::vector<std::uint32_t> AccessorReader::indices(int accessor, const std::string& wanted_by) {
  const tinygltf::Accessor& a = at(accessor, wanted_by);
  const std::string place = place_of(accessor);
  if (a.type != TINYGLTF_TYPE_SCALAR) fail_invalid(place, "indices that are not of type SCALAR");
  check_unsigned(a.componentType, place);
  const Elements from = base(a, place);
  std::vector<std::uint32_t> list(a.count);
  with_component_type(a.componentType, [&](auto zero) {
    using T = decltype(zero);
    const auto index = [](const std::uint8_t* bytes) {
      return static_cast<std::uint32_t>(from_little_endian<T>(bytes));
    };
    for (std::size_t i = 0; i < from.count; ++i) list[i] = index(from.first + i * from.stride);
    if (!a.sparse.isSparse) return;
    const std::vector<std::uint32_t> targets = sparse_targets(a, place);
    const Elements values = sparse_values(a, sizeof(T), place);
    for (std::size_t i = 0; i < targets.size(); ++i)
      list[targets[i]] = index(values.first + i * values.stride);
  });
  check_restart(list, a.componentType, place);
  return list;
}

const tinygltf::Accessor& AccessorReader::at(int accessor, const std::string& wanted_by) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size())
    fail_invalid(wanted_by,
                 fmt::format("accessor {} of {} does not exist", accessor, model_.accessors.size()));
  return model_.accessors[static_cast<std::size_t>(accessor)];
}

/// The elements before sparse substitution; none where they are zeros.
AccessorReader::Elements AccessorReader::base(const tinygltf::Accessor& accessor, const std::string& place) {
  if (accessor.bufferView < 0) {
    check_zeros(accessor, place);
    return {};
  }
  const auto size =
      component_size(accessor.componentType) *
      static_cast<std::size_t>(tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type)));
  return elements(accessor.bufferView, accessor.byteOffset, accessor.count, size, place, false);
}

/// Zeros cost no bytes of the file, so a few bytes could ask for all memory there is.
void AccessorReader::check_zeros(const tinygltf::Accessor& accessor, const std::string& place) const {
  constexpr std::size_t always_fine = 1 << 16;
  if (accessor.count > file_size_ + always_fine)
    fail_unsupported(place, fmt::format("{} elements without a buffer view in a file of {} bytes",
                                        accessor.count, file_size_));
}

AccessorReader::Elements AccessorReader::elements(int view_index, std::uint64_t offset, std::uint64_t count,
                                                  std::size_t size, const std::string& place,
                                                  bool tightly_packed) {
  if (static_cast<std::size_t>(view_index) >= model_.bufferViews.size())
    fail_invalid(place,
                 fmt::format("buffer view {} of {} does not exist", view_index, model_.bufferViews.size()));
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(view_index)];
  const std::string view_place = fmt::format("bufferViews[{}]", view_index);
  const ByteSpan buffer = buffers_.bytes(static_cast<std::size_t>(view.buffer), view_place);
  if (view.byteOffset > buffer.size() || view.byteLength > buffer.size() - view.byteOffset)
    fail_invalid(view_place, fmt::format("bytes {} + {} lie outside a buffer of {}", view.byteOffset,
                                         view.byteLength, buffer.size()));

  const std::size_t stride = view.byteStride == 0 || tightly_packed ? size : view.byteStride;
  if (stride < size)
    fail_invalid(view_place, fmt::format("byteStride {} for elements of {} bytes", stride, size));
  if (count == 0) return {};
  const bool fits = offset <= view.byteLength && size <= view.byteLength - offset &&
                    count - 1 <= (view.byteLength - offset - size) / stride;
  if (!fits)
    fail_invalid(place,
                 fmt::format("{} elements of {} bytes from byte {} at stride {} do not fit {} of {} bytes",
                             count, size, offset, stride, view_place, view.byteLength));
  return {buffer.data() + view.byteOffset + offset, stride, count};
}

std::vector<std::uint32_t> AccessorReader::sparse_targets(const tinygltf::Accessor& accessor,
                                                          const std::string& place) {
  const auto& sparse = accessor.sparse;
  const std::string indices_place = place + ".sparse.indices";
  check_unsigned(sparse.indices.componentType, indices_place);
  const auto count = static_cast<std::size_t>(sparse.count);
  const Elements from =
      elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
               component_size(sparse.indices.componentType), indices_place, true);
  std::vector<std::uint32_t> targets(from.count);
  with_component_type(sparse.indices.componentType, [&](auto zero) {
    for (std::size_t i = 0; i < from.count; ++i)
      targets[i] =
          static_cast<std::uint32_t>(from_little_endian<decltype(zero)>(from.first + i * from.stride));
  });
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i] >= accessor.count)
      fail_invalid(indices_place, fmt::format("element {} is {}, but the accessor has {} elements", i,
                                              targets[i], accessor.count));
    if (i > 0 && targets[i] <= targets[i - 1])
      fail_invalid(indices_place, fmt::format("element {} does not exceed the one before it", i));
  }
  return targets;
}

AccessorReader::Elements AccessorReader::sparse_values(const tinygltf::Accessor& accessor, std::size_t size,
                                                       const std::string& place) {
  const auto& sparse = accessor.sparse;
  return elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                  static_cast<std::size_t>(sparse.count), size, place + ".sparse.values", true);
}

}  // namespace provis
