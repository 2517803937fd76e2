#include "src/scene/gltf_buffers.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/uri.hpp"

namespace provis {
namespace {

constexpr JsonMember buffer_members[] = {{"uri", JsonKind::text}, {"byteLength", JsonKind::count}};

}  // namespace

GltfBuffers::GltfBuffers(const Json& document, std::filesystem::path folder, std::optional<ByteSpan> binary)
    : folder_(std::move(folder)), binary_(binary) {
  const Json* all = find_member(document, "buffers");
  if (all == nullptr) return;
  require_array(*all, "buffers");
  for (std::size_t i = 0; i < all->size(); ++i) {
    const Json checked = checked_members((*all)[i], fmt::format("buffers[{}]", i), buffer_members);
    Buffer buffer;
    if (const Json* uri = find_member(checked, "uri")) buffer.uri = uri->get<std::string>();
    if (const Json* length = find_member(checked, "byteLength")) buffer.length = length->get<std::uint64_t>();
    buffers_.push_back(std::move(buffer));
  }
}

ByteSpan GltfBuffers::bytes(std::size_t index, const std::string& wanted_by) {
  if (index >= buffers_.size())
    fail_invalid(wanted_by, fmt::format("buffer {} of {} does not exist", index, buffers_.size()));
  Buffer& buffer = buffers_[index];
  const std::string place = fmt::format("buffers[{}]", index);
  if (!buffer.length) fail_invalid(place, "byteLength is missing");
  const ByteSpan data = available(buffer, index, place);
  if (data.size() < *buffer.length)
    fail_invalid(place, fmt::format("byteLength is {}, but there are {} bytes", *buffer.length, data.size()));
  return data.first(*buffer.length);
}

std::uint64_t GltfBuffers::loaded_bytes() const {
  std::uint64_t sum = 0;
  for (const Buffer& buffer : buffers_)
    if (buffer.loaded) sum += buffer.loaded->size();
  return sum;
}

ByteSpan GltfBuffers::available(Buffer& buffer, std::size_t index, const std::string& place) {
  if (buffer.loaded) return *buffer.loaded;
  if (!buffer.uri) {
    if (index != 0 || !binary_) fail_invalid(place, "neither a uri nor a binary chunk");
    return *binary_;
  }
  buffer.loaded = data_uri_bytes(*buffer.uri, place + ".uri");
  if (!buffer.loaded) {
    const auto file = file_in_folder(*buffer.uri, folder_, place + ".uri");
    try {
      buffer.loaded = read_file(file);
    } catch (const Error& error) {
      throw Error(error.code(), place + ".uri", fmt::format("{}: {}", *buffer.uri, error.what()));
    }
  }
  return *buffer.loaded;
}

}  // namespace provis
