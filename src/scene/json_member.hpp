#pragma once
// Members of a JSON object, checked for kind and range, with the place they stand at.

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>

namespace provis {

using Json = nlohmann::json;

enum class JsonKind {
  index,   ///< an integer from 0 to 2^31 - 1
  count,   ///< an integer from 0 to 2^53: larger ones are no exact JSON numbers
  flag,    ///< true or false
  number,  ///< finite
  text,
  indices,  ///< an array of index
  numbers,  ///< an array of number
};

struct JsonMember {
  const char* name;
  JsonKind kind;
  bool required = false;
  std::size_t length = 0;  ///< of an array; 0 takes any
};

/// The named member or nullptr.
const Json* find_member(const Json& object, const char* name);

/// A new object of the listed members alone; integers written as 3.0 become integers.
///
/// Throws:     Error::invalid_input naming the member: missing, of another kind, or out of range
Json checked_members(const Json& object, const std::string& place, std::span<const JsonMember> members);

/// Throws Error::invalid_input unless the value is of that type.
void require_object(const Json& value, const std::string& place);
void require_array(const Json& value, const std::string& place);

}  // namespace provis
