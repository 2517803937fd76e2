#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

#include "src/scene/failure.hpp"
#include "src/scene/ply_format.hpp"

namespace provis {
namespace {

constexpr std::pair<std::string_view, PlyType> type_names[] = {
    {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
    {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
    {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
    {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
    {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
    {"float64", PlyType::float64}};

/// A carriage return before a line feed counts as blank.
constexpr char blanks[] = " \t\r";

using Words = std::vector<std::string_view>;

Words words_of(std::string_view line) {
  Words words;
  for (;;) {
    const std::size_t first = line.find_first_not_of(blanks);
    if (first == std::string_view::npos) return words;
    line.remove_prefix(first);
    const std::size_t end = std::min(line.find_first_of(blanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

std::optional<std::size_t> find_property(const PlyElement& element, const std::string& wanted, bool list) {
  for (std::size_t i = 0; i < element.properties.size(); ++i)
    if (element.properties[i].name == wanted && element.properties[i].length_type.has_value() == list)
      return i;
  return std::nullopt;
}

/// Of two properties of one name that nobody reads, it does not matter which one is meant.
bool is_geometry(const std::string& property) {
  constexpr std::array names = {"x",  "y",      "z",     "vx",           "vy",
                                "vz", "radius", "flags", "vertex_index", "vertex_indices"};
  return std::ranges::find(names, property) != names.end();
}

class HeaderReader {
 public:
  explicit HeaderReader(ByteSpan file) : text_(reinterpret_cast<const char*>(file.data()), file.size()) {}

  PlyHeader read() {
    if (next_line() != Words{"ply"}) fail("the first line is not \"ply\"");
    for (Words words = next_line(); words != Words{"end_header"}; words = next_line()) add_line(words);
    if (!has_format_) fail("end_header before a format line");
    header_.body_offset = position_;
    header_.body_line = line_ + 1;
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { fail_invalid(fmt::format("line {}", line_), what); }

  /// Lines end in \n or \r\n, even mixed. A file whose first line ends in \r alone is taken at its word:
  /// its body may begin with the byte \n.
  Words next_line() {
    if (++line_ == 1) {
      const std::size_t end = text_.find_first_of("\r\n");
      const bool lone =
          end != std::string_view::npos && text_[end] == '\r' && text_.substr(end + 1, 1) != "\n";
      line_end_ = lone ? '\r' : '\n';
    }
    const std::size_t end = text_.find(line_end_, position_);
    if (end == std::string_view::npos) fail("the header ends without end_header");
    const std::string_view line = text_.substr(position_, end - position_);
    position_ = end + 1;
    return words_of(line);
  }

  void add_line(const Words& words) {
    if (words.empty() || words[0] == "obj_info") return;
    if (words[0] == "comment") return add_comment(words);
    if (words[0] == "format") return add_format(words);
    if (!has_format_) fail("no format line yet");
    if (words[0] == "element") return add_element(words);
    if (words[0] == "property") return add_property(words);
    fail(fmt::format("unknown keyword \"{}\"", words[0]));
  }

  void add_comment(const Words& words) {
    if (words.size() == 3 && words[1] == ply_hash_comment) header_.hash = std::string(words[2]);
  }

  void add_format(const Words& words) {
    if (words.size() != 3) fail("a format line has three words");
    if (has_format_) fail("a second format line");
    if (words[1] == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (words[1] == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (words[1] == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      fail(fmt::format("unknown format \"{}\"", words[1]));
    if (words[2] != "1.0")
      fail_unsupported(fmt::format("line {}", line_), fmt::format("PLY version {}", words[2]));
    has_format_ = true;
  }

  void add_element(const Words& words) {
    if (words.size() != 3) fail("an element line has three words");
    PlyElement element;
    element.name = words[1];
    element.line = line_;
    const char* end = words[2].data() + words[2].size();
    const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
    if (stop != end || error != std::errc()) fail(fmt::format("\"{}\" is no count", words[2]));
    if (std::ranges::any_of(header_.elements, [&](const PlyElement& e) { return e.name == element.name; }))
      fail(fmt::format("a second element {}", element.name));
    header_.elements.push_back(std::move(element));
  }

  void add_property(const Words& words) {
    if (header_.elements.empty()) fail("a property before any element");
    const bool list = words.size() > 1 && words[1] == "list";
    if (words.size() != (list ? 5u : 3u))
      fail(list ? "a list property has five words" : "a property line has three words");
    PlyProperty property;
    property.name = words.back();
    property.type = type_named(words[words.size() - 2]);
    if (list) property.length_type = type_named(words[2]);
    if (list && !is_integer(*property.length_type)) fail("the length of a list is no integer type");
    PlyElement& element = header_.elements.back();
    if (find_property(element, property.name, list) && is_geometry(property.name))
      fail(fmt::format("a second property {} of {}", property.name, element.name));
    element.properties.push_back(std::move(property));
  }

  PlyType type_named(std::string_view word) const {
    for (const auto& [name, type] : type_names)
      if (name == word) return type;
    fail(fmt::format("unknown type \"{}\"", word));
  }

  std::string_view text_;
  std::size_t position_ = 0, line_ = 0;
  char line_end_ = '\n';
  bool has_format_ = false;
  PlyHeader header_;
};

}  // namespace

std::size_t size_of(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

bool is_integer(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

std::optional<std::size_t> PlyElement::scalar(const std::string& wanted) const {
  return find_property(*this, wanted, false);
}

std::optional<std::size_t> PlyElement::list(const std::string& wanted) const {
  return find_property(*this, wanted, true);
}

PlyHeader read_ply_header(ByteSpan file) { return HeaderReader(file).read(); }

}  // namespace provis
