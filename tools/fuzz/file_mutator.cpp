#include "tools/fuzz/file_mutator.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

namespace provis::fuzz {
namespace {

using Json = nlohmann::json;

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t header_size = 12, chunk_header_size = 8;

struct Glb {
  Bytes json;
  std::optional<Bytes> binary;
};

std::uint32_t word(const Bytes& bytes, std::size_t offset) {
  std::uint32_t value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

void append_word(Bytes& bytes, std::size_t value) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// The chunk that begins there, as far as the file reaches.
Bytes chunk(const Bytes& file, std::size_t offset) {
  const std::size_t first = offset + chunk_header_size;
  const std::size_t size = std::min<std::size_t>(word(file, offset), file.size() - first);
  return Bytes(file.begin() + static_cast<std::ptrdiff_t>(first),
               file.begin() + static_cast<std::ptrdiff_t>(first + size));
}

std::optional<Glb> split(const Bytes& file) {
  if (file.size() < header_size + chunk_header_size || std::memcmp(file.data(), "glTF", 4) != 0) return {};
  Glb glb{chunk(file, header_size), std::nullopt};
  const std::size_t next = header_size + chunk_header_size + glb.json.size();
  if (file.size() >= next + chunk_header_size) glb.binary = chunk(file, next);
  return glb;
}

void append_chunk(Bytes& file, std::uint32_t type, Bytes data, std::uint8_t padding) {
  while (data.size() % 4 != 0) data.push_back(padding);
  append_word(file, data.size());
  append_word(file, type);
  file.insert(file.end(), data.begin(), data.end());
}

Bytes joined(const Glb& glb) {
  Bytes chunks;
  append_chunk(chunks, json_chunk, glb.json, ' ');
  if (glb.binary) append_chunk(chunks, binary_chunk, *glb.binary, 0);
  Bytes file{'g', 'l', 'T', 'F'};
  append_word(file, 2);
  append_word(file, header_size + chunks.size());
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

std::size_t below(Random& random, std::size_t count) { return random() % count; }

template <class List>
auto& any_of(List& list, Random& random) {
  return list[below(random, std::size(list))];
}

/// Every value of the document, containers before what they hold.
void collect(Json& value, std::vector<Json*>& all) {
  all.push_back(&value);
  if (value.is_structured())
    for (Json& inner : value) collect(inner, all);
}

Json interesting_number(const Json& now, Random& random) {
  static const std::array numbers = {
      Json(-1),           Json(0),          Json(1),     Json(2),     Json(3),          Json(4),
      Json(5),            Json(6),          Json(255),   Json(65535), Json(5120),       Json(5121),
      Json(5122),         Json(5123),       Json(5125),  Json(5126),  Json(2147483647), Json(2147483648u),
      Json(4294967295u),  Json(1ull << 53), Json(1e308), Json(-1e308), Json(0.5),       Json(1e-320),
      Json(~0ull - 3ull), Json(-0.0)};
  if (now.is_number_integer() && below(random, 2) == 0)
    return now.get<std::int64_t>() + static_cast<std::int64_t>(below(random, 9)) - 4;
  return any_of(numbers, random);
}

const char* interesting_text(Random& random) {
  static constexpr std::array texts = {"SCALAR", "VEC3", "VEC4", "MAT4", "LINEAR", "STEP", "CUBICSPLINE",
                                       "translation", "rotation", "scale", "weights", "pointer", "POSITION",
                                       "JOINTS_0", "WEIGHTS_0", "_RADIUS", "TRANSLATION", "ROTATION", "SCALE",
                                       "BLEND", "MASK", "ATTRIBUTES", "TRIANGLES", "INDICES", "NONE",
                                       "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL", "EXT_mesh_gpu_instancing",
                                       "KHR_draco_mesh_compression", "EXT_meshopt_compression", "2.0", ""};
  return any_of(texts, random);
}

void mutate_array(Json& array, Random& random) {
  if (array.empty()) return;
  const std::size_t at = below(random, array.size());
  switch (below(random, 3)) {
    case 0:
      array.erase(at);
      break;
    case 1:
      array.push_back(Json(array[at]));
      break;
    default:
      std::swap(array[at], array[below(random, array.size())]);
  }
}

void mutate_object(Json& object, const Json& other, Random& random) {
  if (!object.empty() && below(random, 2) == 0) {
    auto member = object.begin();
    std::advance(member, static_cast<std::ptrdiff_t>(below(random, object.size())));
    object.erase(member);
  } else if (other.is_object()) {
    object.update(other);
  } else {
    object[interesting_text(random)] = other;
  }
}

void mutate_value(Json& document, Random& random) {
  std::vector<Json*> all;
  collect(document, all);
  Json& value = *any_of(all, random);
  const Json other = *any_of(all, random);  // a copy: the value may hold it
  if (below(random, 8) == 0)
    value = other;
  else if (value.is_array())
    mutate_array(value, random);
  else if (value.is_object())
    mutate_object(value, other, random);
  else if (value.is_string())
    value = interesting_text(random);
  else if (value.is_boolean())
    value = !value.get<bool>();
  else
    value = interesting_number(value, random);
}

/// Changes bytes by the fuzzer's own means.
Bytes mutated_bytes(Bytes bytes, std::size_t most) {
  const std::size_t size = std::min(bytes.size(), most);
  bytes.resize(std::max<std::size_t>(most, 1));
  bytes.resize(LLVMFuzzerMutate(bytes.data(), size, most));
  return bytes;
}

Bytes mutated_json(const Bytes& text, std::size_t most, Random& random) {
  Json document = Json::parse(text.begin(), text.end(), nullptr, false);
  if (document.is_discarded() || below(random, 16) == 0) return mutated_bytes(text, most);
  for (std::size_t n = 1 + below(random, 4); n > 0; --n) mutate_value(document, random);
  const std::string dumped = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  return Bytes(dumped.begin(), dumped.end());
}

}  // namespace

Bytes mutated_file(const Bytes& file, std::size_t most, Random& random) {
  if (below(random, 16) == 0) return mutated_bytes(file, most);
  std::optional<Glb> glb = split(file);
  if (!glb) return !file.empty() && file[0] == '{' ? mutated_json(file, most, random) : mutated_bytes(file, most);
  if (glb->binary && below(random, 3) == 0)
    glb->binary = mutated_bytes(*glb->binary, most);
  else
    glb->json = mutated_json(glb->json, most, random);
  return joined(*glb);
}

}  // namespace provis::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned int seed) {
  provis::fuzz::Random random(seed);
  const auto mutated = provis::fuzz::mutated_file({data, data + size}, most, random);
  const std::size_t kept = std::min(mutated.size(), most);
  std::copy_n(mutated.begin(), kept, data);
  return kept;
}
