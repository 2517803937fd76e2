#include "src/cli/arguments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <vector>

#include "provis/error.hpp"
#include "src/report/picture.hpp"

namespace provis {

namespace {

[[noreturn]] void refuse(const std::string& option, const std::string& wanted, const std::string& text) {
  throw Error(Error::Code::usage, option, fmt::format("expected {}, got \"{}\"", wanted, text));
}

// The whole text as a number, or false.
template <class Number>
bool read(const std::string& text, Number& number) {
  const char* begin = text.data();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  const auto [stop, error] = std::from_chars(begin, end, number);
  return error == std::errc() && stop == end;
}

std::vector<double> numbers(const std::string& option, const std::string& wanted, const std::string& text,
                            std::size_t count) {
  std::vector<double> values;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    double value = 0;
    if (!read(text.substr(begin, end - begin), value) || !std::isfinite(value)) refuse(option, wanted, text);
    values.push_back(value);
    begin = end + 1;
  }
  if (values.size() != count) refuse(option, wanted, text);
  return values;
}

}  // namespace

double parse_number(const std::string& option, const std::string& text) {
  return numbers(option, "a finite number", text, 1)[0];
}

std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t low,
                          std::uint64_t high) {
  std::uint64_t value = 0;
  if (!read(text, value) || value < low || value > high) {
    refuse(option, fmt::format("a whole number from {} to {}", low, high), text);
  }
  return value;
}

Vec3d parse_vec3(const std::string& option, const std::string& text) {
  const std::vector<double> n = numbers(option, "three finite numbers x,y,z", text, 3);
  return {n[0], n[1], n[2]};
}

Window parse_window(const std::string& option, const std::string& text) {
  const std::vector<double> n = numbers(option, "four finite numbers x0,x1,y0,y1", text, 4);
  return {n[0], n[1], n[2], n[3]};
}

std::array<int, 2> parse_size(const std::string& option, const std::string& text) {
  const std::size_t cross = text.find('x');
  std::uint64_t width = 0, height = 0;
  const bool good = cross != std::string::npos && read(text.substr(0, cross), width) &&
                    read(text.substr(cross + 1), height) && width >= 1 && height >= 1 &&
                    width <= max_image_side && height <= max_image_side;
  if (!good) refuse(option, fmt::format("WxH in pixels, each from 1 to {}", max_image_side), text);
  return {static_cast<int>(width), static_cast<int>(height)};
}

}  // namespace provis
