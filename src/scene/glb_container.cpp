#include "src/scene/glb_container.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "src/scene/failure.hpp"
#include "src/scene/little_endian.hpp"

namespace provis {
namespace {

constexpr std::size_t header_size = 12, chunk_header_size = 8;
constexpr std::uint32_t json_type = 0x4E4F534A, binary_type = 0x004E4942;

std::uint32_t word(ByteSpan file, std::size_t offset) {
  return from_little_endian<std::uint32_t>(&file[offset]);
}

std::string at_byte(std::size_t offset) { return fmt::format("byte {}", offset); }

struct Chunk {
  std::uint32_t type;
  ByteSpan data;
};

Chunk chunk_at(ByteSpan file, std::size_t offset) {
  if (file.size() - offset < chunk_header_size) fail_invalid(at_byte(offset), "truncated chunk header");
  const std::size_t size = word(file, offset), rest = file.size() - offset - chunk_header_size;
  if (size > rest)
    fail_invalid(at_byte(offset), fmt::format("a chunk of {} bytes where {} are left", size, rest));
  return {word(file, offset + 4), file.subspan(offset + chunk_header_size, size)};
}

/// The part of the file that its header declares.
ByteSpan declared(ByteSpan file) {
  if (file.size() < header_size) fail_invalid(at_byte(file.size()), "truncated GLB header");
  const std::uint32_t version = word(file, 4), length = word(file, 8);
  if (version == 0) fail_invalid(at_byte(4), "there is no GLB version 0");
  if (version != 2) fail_unsupported(at_byte(4), fmt::format("GLB version {}", version));
  if (length > file.size())
    fail_invalid(at_byte(8),
                 fmt::format("the header declares {} bytes, the file has {}", length, file.size()));
  if (length < header_size)
    fail_invalid(at_byte(8), fmt::format("the header declares only {} bytes", length));
  return file.first(length);
}

}  // namespace

bool is_glb(ByteSpan file) {
  constexpr std::array<std::uint8_t, 4> magic{'g', 'l', 'T', 'F'};
  return file.size() >= magic.size() && std::equal(magic.begin(), magic.end(), file.begin());
}

GlbChunks split_glb(ByteSpan file) {
  const ByteSpan glb = declared(file);
  const Chunk json = chunk_at(glb, header_size);
  if (json.type != json_type) fail_invalid(at_byte(header_size + 4), "the first chunk is not JSON");
  GlbChunks chunks{{reinterpret_cast<const char*>(json.data.data()), json.data.size()}, std::nullopt};

  const std::size_t next = header_size + chunk_header_size + json.data.size();
  // Fewer than a header's bytes are padding that some exporters leave behind the last chunk.
  if (glb.size() - next < chunk_header_size) return chunks;
  const Chunk second = chunk_at(glb, next);
  if (second.type == binary_type) chunks.binary = second.data;
  return chunks;
}

}  // namespace provis
