#include "src/scene/accessor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "src/scene/component_type.hpp"
#include "src/scene/failure.hpp"
#include "src/scene/finite.hpp"
#include "src/scene/gltf_fault.hpp"
#include "src/scene/gltf_reduce.hpp"
#include "src/scene/little_endian.hpp"

namespace provis {
namespace {

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

/// The bit of ElementKind::components that the accessor's components have.
unsigned component_bit(const tinygltf::Accessor& accessor) {
  switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return float_components;
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return accessor.normalized ? normalized_signed : plain_signed;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return accessor.normalized ? normalized_unsigned : plain_unsigned;
    default:
      return long_integers;
  }
}

void check_kind(const tinygltf::Accessor& accessor, const ElementKind& kind, const std::string& place) {
  if (accessor.type != kind.type) fail_invalid(place, fmt::format("{} of another type", kind.what));
  if ((component_bit(accessor) & kind.components) == 0)
    fail_invalid(place, fmt::format("{} of {}component type {}", kind.what,
                                    accessor.normalized ? "normalised " : "", accessor.componentType));
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

const std::vector<Vec3d>& AccessorReader::positions(int accessor, const std::string& wanted_by) {
  const auto found = positions_.find(accessor);
  if (found != positions_.end()) return found->second;
  return positions_.emplace(accessor, vectors(accessor, wanted_by)).first->second;
}

std::vector<Vec3d> AccessorReader::vectors(int accessor, const std::string& wanted_by) {
  const tinygltf::Accessor& a = at(accessor, wanted_by);
  const std::string place = place_of(accessor);
  check_kind(a, {"positions", TINYGLTF_TYPE_VEC3, any_component}, place);
  auto points = read<Vec3d>(a, place, 1, [&a](const std::uint8_t* bytes, Vec3d* to, auto zero) {
    *to = position<decltype(zero)>(bytes, a.normalized);
  });
  check_finite(points, place);
  return points;
}

std::vector<double> AccessorReader::numbers(int accessor, const ElementKind& kind,
                                            const std::string& wanted_by) {
  const tinygltf::Accessor& a = at(accessor, wanted_by);
  const std::string place = place_of(accessor);
  check_kind(a, kind, place);
  const std::size_t components = component_count(a);
  auto values = read<double>(a, place, components, [&](const std::uint8_t* bytes, double* to, auto zero) {
    for (std::size_t c = 0; c < components; ++c)
      to[c] = coordinate<decltype(zero)>(bytes + c * sizeof(zero), a.normalized);
  });
  const auto bad = std::ranges::find_if_not(values, [](double x) { return std::isfinite(x); });
  if (bad != values.end())
    fail_invalid(place, fmt::format("element {} is not finite",
                                    static_cast<std::size_t>(bad - values.begin()) / components));
  return values;
}

std::vector<std::uint32_t> AccessorReader::indices(int accessor, const std::string& wanted_by) {
  const tinygltf::Accessor& a = at(accessor, wanted_by);
  const std::string place = place_of(accessor);
  if (a.type != TINYGLTF_TYPE_SCALAR) fail_invalid(place, "indices that are not of type SCALAR");
  check_unsigned(a.componentType, place);
  auto list = read<std::uint32_t>(a, place, 1, [](const std::uint8_t* bytes, std::uint32_t* to, auto zero) {
    *to = static_cast<std::uint32_t>(from_little_endian<decltype(zero)>(bytes));
  });
  check_restart(list, a.componentType, place);
  return list;
}

std::size_t AccessorReader::count(int accessor, const std::string& wanted_by) {
  const tinygltf::Accessor& a = at(accessor, wanted_by);
  base(a, place_of(accessor));
  return a.count;
}

/// Calls decode(bytes, value, zero of the component's type) for the base's elements, then for sparse ones.
template <class Value, class Decode>
std::vector<Value> AccessorReader::read(const tinygltf::Accessor& a, const std::string& place,
                                        std::size_t values_per_element, const Decode& decode) {
  const Elements from = base(a, place);  // before memory is taken: it compares the count with the bytes
  std::vector<Value> list(a.count * values_per_element);
  with_component_type(a.componentType, [&](auto zero) {
    const auto put = [&](std::size_t i, const std::uint8_t* bytes) {
      decode(bytes, list.data() + i * values_per_element, zero);
    };
    for (std::size_t i = 0; i < from.count; ++i) put(i, from.first + i * from.stride);
    if (!a.sparse.isSparse) return;
    const std::vector<std::uint32_t> targets = sparse_targets(a, place);
    const Elements values = sparse_values(a, component_count(a) * sizeof(zero), place);
    for (std::size_t i = 0; i < targets.size(); ++i) put(targets[i], values.first + i * values.stride);
  });
  return list;
}

int AccessorReader::supply(int accessor, int view, std::size_t count, const std::string& wanted_by) {
  Supplied copy{at(accessor, wanted_by), accessor};
  copy.accessor.bufferView = view;
  copy.accessor.byteOffset = 0;
  copy.accessor.count = count;
  supplied_.push_back(std::move(copy));
  return first_index_of_ours + static_cast<int>(supplied_.size()) - 1;
}

std::string AccessorReader::place_of(int accessor) const {
  const Supplied* supplied = supplied_at(accessor);
  return fmt::format("accessors[{}]", supplied == nullptr ? accessor : supplied->declared);
}

const AccessorReader::Supplied* AccessorReader::supplied_at(int accessor) const {
  const auto i = static_cast<std::size_t>(accessor) - first_index_of_ours;
  return accessor >= first_index_of_ours && i < supplied_.size() ? &supplied_[i] : nullptr;
}

const tinygltf::Accessor& AccessorReader::at(int accessor, const std::string& wanted_by) const {
  if (const Supplied* supplied = supplied_at(accessor)) return supplied->accessor;
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size())
    fail_invalid(wanted_by,
                 fmt::format("accessor {} of {} does not exist", accessor, model_.accessors.size()));
  const tinygltf::Accessor& found = model_.accessors[static_cast<std::size_t>(accessor)];
  check_usable(found.extras);
  return found;
}

/// The elements before sparse substitution; none where they are zeros.
AccessorReader::Elements AccessorReader::base(const tinygltf::Accessor& accessor, const std::string& place) {
  if (accessor.bufferView < 0) {
    check_zeros(accessor, place);
    return {};
  }
  const std::size_t size = component_size(accessor.componentType) * component_count(accessor);
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
  const GltfViews::View view = views_.view(view_index, place);
  const std::string view_place = fmt::format("bufferViews[{}]", view_index);
  const std::size_t stride = view.stride == 0 || tightly_packed ? size : view.stride;
  if (stride < size)
    fail_invalid(view_place, fmt::format("byteStride {} for elements of {} bytes", stride, size));
  if (count == 0) return {};
  const std::size_t length = view.bytes.size();
  const bool fits =
      offset <= length && size <= length - offset && count - 1 <= (length - offset - size) / stride;
  if (!fits)
    fail_invalid(place,
                 fmt::format("{} elements of {} bytes from byte {} at stride {} do not fit {} of {} bytes",
                             count, size, offset, stride, view_place, length));
  return {view.bytes.data() + offset, stride, count};
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
