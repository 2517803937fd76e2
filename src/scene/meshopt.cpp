#include "src/scene/meshopt.hpp"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

constexpr std::string_view attributes = "ATTRIBUTES", triangles = "TRIANGLES", indices = "INDICES";
constexpr std::array modes = {attributes, triangles, indices};
constexpr std::string_view none = "NONE", octahedral = "OCTAHEDRAL", quaternion = "QUATERNION",
                           exponential = "EXPONENTIAL";
constexpr std::array filters = {none, octahedral, quaternion, exponential};

void check_stride(const MeshoptLayout& layout, bool fits, const char* allowed, const std::string& place) {
  if (!fits)
    fail_invalid(place, fmt::format("byteStride {} in mode {} with filter {}, which allow {}", layout.stride,
                                    layout.mode, layout.filter, allowed));
}

void check_attributes(const MeshoptLayout& layout, const std::string& place) {
  const std::uint64_t stride = layout.stride;
  check_stride(layout, stride != 0 && stride % 4 == 0 && stride <= 256, "multiples of 4 up to 256", place);
  if (layout.filter == octahedral) check_stride(layout, stride == 4 || stride == 8, "4 and 8", place);
  if (layout.filter == quaternion) check_stride(layout, stride == 8, "8", place);
}

void check_indices(const MeshoptLayout& layout, const std::string& place) {
  check_stride(layout, layout.stride == 2 || layout.stride == 4, "2 and 4", place);
  if (layout.filter != none)
    fail_invalid(place, fmt::format("filter {} in mode {}", layout.filter, layout.mode));
  if (layout.mode == triangles && layout.count % 3 != 0)
    fail_invalid(place, fmt::format("{} indices are no whole number of triangles", layout.count));
}

/// The length that so many elements need at least. ATTRIBUTES: one byte of header, two bits for every 16
/// bytes of the result, a tail of 32 bytes or one element. TRIANGLES: header, one byte for each, a tail of
/// 16. INDICES: header, one byte for each, a tail of 4. So a byte becomes at most 64, 12 or 4.
std::uint64_t least_size(const MeshoptLayout& layout) {
  if (layout.mode == triangles) return 1 + layout.count / 3 + 16;
  if (layout.mode == indices) return 1 + layout.count + 4;
  return 1 + (layout.count * layout.stride + 63) / 64 + std::max<std::uint64_t>(32, layout.stride);
}

int decode(ByteSpan compressed, const MeshoptLayout& layout, Bytes& bytes) {
  if (layout.mode == triangles)
    return meshopt_decodeIndexBuffer(bytes.data(), layout.count, layout.stride, compressed.data(),
                                     compressed.size());
  if (layout.mode == indices)
    return meshopt_decodeIndexSequence(bytes.data(), layout.count, layout.stride, compressed.data(),
                                       compressed.size());
  return meshopt_decodeVertexBuffer(bytes.data(), layout.count, layout.stride, compressed.data(),
                                    compressed.size());
}

void apply_filter(const MeshoptLayout& layout, Bytes& bytes) {
  if (layout.filter == octahedral) meshopt_decodeFilterOct(bytes.data(), layout.count, layout.stride);
  if (layout.filter == quaternion) meshopt_decodeFilterQuat(bytes.data(), layout.count, layout.stride);
  if (layout.filter == exponential) meshopt_decodeFilterExp(bytes.data(), layout.count, layout.stride);
}

/// The library's codes, which its header does not name.
const char* reason(int code) {
  switch (code) {
    case -1:
      return "of another mode or version";
    case -2:
      return "too short for its elements";
    default:
      return "longer than its elements";
  }
}

}  // namespace

void check_layout(const MeshoptLayout& layout, const std::string& place) {
  if (std::ranges::find(modes, layout.mode) == modes.end())
    fail_invalid(place + ".mode", fmt::format("unknown mode \"{}\"", layout.mode));
  if (std::ranges::find(filters, layout.filter) == filters.end())
    fail_invalid(place + ".filter", fmt::format("unknown filter \"{}\"", layout.filter));
  if (layout.mode == attributes)
    check_attributes(layout, place);
  else
    check_indices(layout, place);
}

Bytes decode_meshopt(ByteSpan compressed, const MeshoptLayout& layout, const std::string& place) {
  if (compressed.size() < least_size(layout))
    fail_invalid(place, fmt::format("{} elements of {} bytes take {} compressed bytes at least, not {}",
                                    layout.count, layout.stride, least_size(layout), compressed.size()));
  Bytes bytes(layout.count * layout.stride);
  const int code = decode(compressed, layout, bytes);
  if (code != 0) fail_invalid(place, fmt::format("the compressed data is {}", reason(code)));
  apply_filter(layout, bytes);
  return bytes;
}

}  // namespace provis
