#pragma once
// The header of a PLY file: what its body holds, in which order and encoding.
// Source: G. Turk, The PLY polygon file format, 1994.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "src/scene/file_bytes.hpp"

namespace provis {

/// The comment that carries a scene's hash: this word, a space, 64 hexadecimal digits.
inline constexpr char ply_hash_comment[] = "provis-scene-hash";

enum class PlyEncoding { ascii, little_endian, big_endian };

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::size_t size_of(PlyType type);
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;     ///< of the value, or of each item of a list
  std::optional<PlyType> length_type;  ///< present for lists
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::size_t line = 0;  ///< of the header

  /// The position of a property among the element's, scalar or list as asked.
  std::optional<std::size_t> scalar(const std::string& wanted) const;
  std::optional<std::size_t> list(const std::string& wanted) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::optional<std::string> hash;  ///< of ply_hash_comment
  std::size_t body_offset = 0;      ///< bytes
  std::size_t body_line = 0;        ///< counted from 1
};

/// Lines may end in \n, \r\n or \r.
///
/// Throws:     Error::invalid_input naming the line
PlyHeader read_ply_header(ByteSpan file);

}  // namespace provis
