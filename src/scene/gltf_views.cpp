#include "src/scene/gltf_views.hpp"

#include <fmt/format.h>

#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/gltf_fault.hpp"
#include "src/scene/gltf_reduce.hpp"
#include "src/scene/meshopt.hpp"

namespace provis {
namespace {

/// The reduced document holds the numbers of an extension as doubles.
std::uint64_t count_of(const tinygltf::Value& extension, const char* name) {
  return static_cast<std::uint64_t>(extension.Get(name).GetNumberAsDouble());
}

MeshoptLayout layout_of(const tinygltf::Value& extension) {
  MeshoptLayout layout;
  layout.mode = extension.Get("mode").Get<std::string>();
  layout.filter = extension.Has("filter") ? extension.Get("filter").Get<std::string>() : "NONE";
  layout.count = count_of(extension, "count");
  layout.stride = count_of(extension, "byteStride");
  return layout;
}

void check_against(const tinygltf::BufferView& view, const MeshoptLayout& layout, const std::string& place) {
  if (view.byteStride != 0 && view.byteStride != layout.stride)
    fail_invalid(place, fmt::format("byteStride {}, but the view has {}", layout.stride, view.byteStride));
  if (view.byteLength != layout.count * layout.stride)
    fail_invalid(place, fmt::format("{} elements of {} bytes, but the view has {} bytes", layout.count,
                                    layout.stride, view.byteLength));
}

}  // namespace

GltfViews::View GltfViews::view(int index, const std::string& wanted_by) {
  const auto found = kept_.find(index);
  const std::size_t i = static_cast<std::size_t>(index);
  if (index >= first_index_of_ours && found != kept_.end()) return {found->second, 0};
  if (i >= model_.bufferViews.size())
    fail_invalid(wanted_by,
                 fmt::format("buffer view {} of {} does not exist", index, model_.bufferViews.size()));
  const tinygltf::BufferView& view = model_.bufferViews[i];
  check_usable(view.extras);
  if (found != kept_.end()) return {found->second, view.byteStride};
  const std::string place = fmt::format("bufferViews[{}]", index);
  if (view.extensions.count(meshopt_extension) != 0) return {decoded(index, place), view.byteStride};
  return {part(view.buffer, view.byteOffset, view.byteLength, place), view.byteStride};
}

int GltfViews::add(Bytes bytes) {
  kept_.emplace(next_, std::move(bytes));
  return next_++;
}

ByteSpan GltfViews::part(int buffer, std::uint64_t offset, std::uint64_t length, const std::string& place) {
  const ByteSpan bytes = buffers_.bytes(static_cast<std::size_t>(buffer), place);
  if (offset > bytes.size() || length > bytes.size() - offset)
    fail_invalid(place,
                 fmt::format("bytes {} + {} lie outside a buffer of {}", offset, length, bytes.size()));
  return bytes.subspan(offset, length);
}

ByteSpan GltfViews::decoded(int index, const std::string& view_place) {
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(index)];
  const tinygltf::Value& extension = view.extensions.at(meshopt_extension);
  const std::string place = fmt::format("{}.extensions.{}", view_place, meshopt_extension);
  const MeshoptLayout layout = layout_of(extension);
  check_layout(layout, place);
  check_against(view, layout, place);
  const std::uint64_t offset = extension.Has("byteOffset") ? count_of(extension, "byteOffset") : 0;
  const ByteSpan compressed =
      part(static_cast<int>(count_of(extension, "buffer")), offset, count_of(extension, "byteLength"), place);
  return kept_.emplace(index, decode_meshopt(compressed, layout, place)).first->second;
}

}  // namespace provis
