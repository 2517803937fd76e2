#include "src/scene/ply_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "src/scene/failure.hpp"
#include "src/scene/little_endian.hpp"

namespace provis {
namespace {

bool is_blank(std::uint8_t c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(std::uint8_t c) { return c == '\n' || c == '\r'; }

template <class T>
double binary_number(const std::uint8_t* bytes, PlyEncoding encoding) {
  return static_cast<double>(encoding == PlyEncoding::big_endian ? from_big_endian<T>(bytes)
                                                                 : from_little_endian<T>(bytes));
}

/// The number that the whole word stands for, in that type; nullopt if it is none or out of range.
template <class T>
std::optional<double> ascii_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  T value{};
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end) return std::nullopt;
  if (error == std::errc()) return static_cast<double>(value);
  if constexpr (std::is_floating_point_v<T>) {
    // from_chars has one error for numbers too large and too small; a small one is rounded like any other.
    const std::string text(word);
    if constexpr (std::is_same_v<T, float>)
      value = std::strtof(text.c_str(), nullptr);
    else
      value = std::strtod(text.c_str(), nullptr);
    if (std::isfinite(value)) return static_cast<double>(value);
  }
  return std::nullopt;
}

std::optional<double> ascii_number(std::string_view word, PlyType type) {
  switch (type) {
    case PlyType::int8:
      return ascii_number<std::int8_t>(word);
    case PlyType::uint8:
      return ascii_number<std::uint8_t>(word);
    case PlyType::int16:
      return ascii_number<std::int16_t>(word);
    case PlyType::uint16:
      return ascii_number<std::uint16_t>(word);
    case PlyType::int32:
      return ascii_number<std::int32_t>(word);
    case PlyType::uint32:
      return ascii_number<std::uint32_t>(word);
    case PlyType::float32:
      return ascii_number<float>(word);
    case PlyType::float64:
      return ascii_number<double>(word);
  }
  return std::nullopt;
}

}  // namespace

PlyBody::PlyBody(ByteSpan file, const PlyHeader& header)
    : file_(file),
      encoding_(header.encoding),
      body_offset_(header.body_offset),
      body_line_(header.body_line),
      position_(header.body_offset),
      row_position_(header.body_offset),
      counted_to_(header.body_offset),
      counted_line_(header.body_line) {}

void PlyBody::check_count(const PlyElement& element) const {
  std::uint64_t least = 0;
  for (const PlyProperty& property : element.properties)
    least += encoding_ == PlyEncoding::ascii ? 2 : size_of(property.length_type.value_or(property.type));
  // The last word of an ASCII file needs nothing behind it.
  const std::uint64_t available = rest() + (encoding_ == PlyEncoding::ascii ? 1 : 0);
  if (least != 0 && element.count > available / least)
    fail(position_,
         fmt::format("{} of element {}, declared in line {}, do not fit the {} bytes that are left",
                     element.count, element.name, element.line, rest()));
}

void PlyBody::read_row(const PlyElement& element, std::size_t wanted_list, PlyRow& row) {
  row.scalars.assign(element.properties.size(), 0);
  row.list.clear();
  row_position_ = position_;
  for (std::size_t p = 0; p < element.properties.size(); ++p) {
    const PlyProperty& property = element.properties[p];
    if (!property.length_type) {
      row.scalars[p] = value(property.type);
      continue;
    }
    const double length = value(*property.length_type);
    if (length < 0) fail(row_position_, fmt::format("{} has {} items", property.name, length));
    for (double i = 0; i < length; ++i) {
      const double item = value(property.type);
      if (p == wanted_list) row.list.push_back(item);
    }
  }
  if (encoding_ == PlyEncoding::ascii && !element.properties.empty()) end_ascii_row();
}

void PlyBody::check_end() const {
  const auto left = file_.subspan(position_);
  const auto stray =
      std::ranges::find_if_not(left, [](std::uint8_t c) { return c == 0 || is_blank(c) || is_line_end(c); });
  if (stray != left.end())
    fail(position_ + static_cast<std::size_t>(stray - left.begin()), "more content than the header declares");
}

std::string PlyBody::row_place() const { return place(row_position_); }

void PlyBody::fail(std::size_t position, const std::string& what) const {
  fail_invalid(place(position), what);
}

/// Lines are counted only here: nobody needs their numbers while all goes well. Where many rows are left
/// out, each is counted from the one before.
std::string PlyBody::place(std::size_t position) const {
  if (encoding_ != PlyEncoding::ascii) return fmt::format("byte {}", position);
  // A row is read from where the last one ended: skip to its first word.
  while (position < file_.size() && (is_blank(file_[position]) || is_line_end(file_[position]))) ++position;
  if (position < counted_to_) {
    counted_to_ = body_offset_;
    counted_line_ = body_line_;
  }
  for (; counted_to_ < position; ++counted_to_) {
    const bool followed = counted_to_ + 1 < file_.size() && file_[counted_to_ + 1] == '\n';
    counted_line_ += file_[counted_to_] == '\n' || (file_[counted_to_] == '\r' && !followed);
  }
  return fmt::format("line {}", counted_line_);
}

double PlyBody::value(PlyType type) {
  return encoding_ == PlyEncoding::ascii ? ascii_value(type) : binary_value(type);
}

double PlyBody::binary_value(PlyType type) {
  const std::size_t size = size_of(type);
  if (rest() < size) fail(position_, "the file ends inside an element");
  const std::uint8_t* bytes = file_.data() + position_;
  position_ += size;
  switch (type) {
    case PlyType::int8:
      return binary_number<std::int8_t>(bytes, encoding_);
    case PlyType::uint8:
      return binary_number<std::uint8_t>(bytes, encoding_);
    case PlyType::int16:
      return binary_number<std::int16_t>(bytes, encoding_);
    case PlyType::uint16:
      return binary_number<std::uint16_t>(bytes, encoding_);
    case PlyType::int32:
      return binary_number<std::int32_t>(bytes, encoding_);
    case PlyType::uint32:
      return binary_number<std::uint32_t>(bytes, encoding_);
    case PlyType::float32:
      return binary_number<float>(bytes, encoding_);
    case PlyType::float64:
      return binary_number<double>(bytes, encoding_);
  }
  return 0;
}

double PlyBody::ascii_value(PlyType type) {
  const std::string_view word = next_word();
  if (const auto number = ascii_number(word, type)) return *number;
  const auto start =
      static_cast<std::size_t>(reinterpret_cast<const std::uint8_t*>(word.data()) - file_.data());
  fail(start, fmt::format("\"{}\" is no number of the declared type", word.substr(0, 40)));
}

std::string_view PlyBody::next_word() {
  while (position_ < file_.size() && (is_blank(file_[position_]) || is_line_end(file_[position_])))
    ++position_;
  const std::size_t start = position_;
  while (position_ < file_.size() && !is_blank(file_[position_]) && !is_line_end(file_[position_]))
    ++position_;
  if (start == position_) fail(position_, "the file ends inside an element");
  return {reinterpret_cast<const char*>(file_.data()) + start, position_ - start};
}

/// Values left over would be taken for the next row's, and every row after it would be wrong.
void PlyBody::end_ascii_row() {
  while (position_ < file_.size() && is_blank(file_[position_])) ++position_;
  if (position_ < file_.size() && !is_line_end(file_[position_]))
    fail(position_, "more values than the header declares");
}

}  // namespace provis
