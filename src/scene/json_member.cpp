#include "src/scene/json_member.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

constexpr std::uint64_t largest_index = first_index_of_ours - 1, largest_int = (std::uint64_t{1} << 31) - 1,
                        largest_count = std::uint64_t{1} << 53;

Json checked_integer(const Json& value, const std::string& place, std::uint64_t largest) {
  if (value.is_number_unsigned()) {
    if (value.get<std::uint64_t>() <= largest) return value;
  } else if (value.is_number_float()) {
    const double x = value.get<double>();
    if (x >= 0 && x <= static_cast<double>(largest) && x == std::floor(x))
      return static_cast<std::uint64_t>(x);
  }
  if (value.is_number())
    throw WrongKind(place, fmt::format("{} is no integer from 0 to {}", value.dump(), largest));
  throw WrongKind(place, fmt::format("{} instead of an integer", value.type_name()));
}

Json checked_value(const Json& value, const std::string& place, const JsonMember& member);

Json checked_array(const Json& value, const std::string& place, const JsonMember& member, JsonKind element) {
  require_array(value, place);
  if (member.length != 0 && value.size() != member.length)
    fail_invalid(place, fmt::format("{} numbers instead of {}", value.size(), member.length));
  Json array = Json::array();
  for (std::size_t i = 0; i < value.size(); ++i)
    array.push_back(checked_value(value[i], fmt::format("{}[{}]", place, i), {"", element}));
  return array;
}

Json checked_value(const Json& value, const std::string& place, const JsonMember& member) {
  const auto expect = [&](bool fits, const char* what) {
    if (!fits) throw WrongKind(place, fmt::format("{} instead of {}", value.type_name(), what));
    return value;
  };
  switch (member.kind) {
    case JsonKind::index:
      return checked_integer(value, place, largest_index);
    case JsonKind::small_count:
      return checked_integer(value, place, largest_int);
    case JsonKind::count:
      return checked_integer(value, place, largest_count);
    case JsonKind::flag:
      return expect(value.is_boolean(), "true or false");
    case JsonKind::number:
      return expect(value.is_number(), "a number");
    case JsonKind::text:
      return expect(value.is_string(), "a string");
    case JsonKind::indices:
      return checked_array(value, place, member, JsonKind::index);
    case JsonKind::numbers:
      return checked_array(value, place, member, JsonKind::number);
  }
  return value;
}

}  // namespace

const Json* find_member(const Json& object, const char* name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

Json checked_members(const Json& object, const std::string& place, std::span<const JsonMember> members) {
  require_object(object, place);
  Json checked = Json::object();
  for (const JsonMember& member : members) {
    const Json* value = find_member(object, member.name);
    if (value != nullptr)
      checked[member.name] = checked_value(*value, place + "." + member.name, member);
    else if (member.required)
      fail_invalid(place, fmt::format("{} is missing", member.name));
  }
  return checked;
}

void require_object(const Json& value, const std::string& place) {
  if (!value.is_object()) throw WrongKind(place, fmt::format("{} instead of an object", value.type_name()));
}

void require_array(const Json& value, const std::string& place) {
  if (!value.is_array()) throw WrongKind(place, fmt::format("{} instead of an array", value.type_name()));
}

}  // namespace provis
