#pragma once
// Members of a JSON object, checked for kind and range, with the place they stand at.

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include "provis/error.hpp"

namespace provis {

using Json = nlohmann::json;

/// No index of a document reaches it, so that what the loader adds to a document can be told from it.
inline constexpr int first_index_of_ours = 1 << 30;

enum class JsonKind {
  index,        ///< an integer from 0 to 2^30 - 1
  small_count,  ///< an integer from 0 to 2^31 - 1, which an int holds
  count,        ///< an integer from 0 to 2^53: larger ones are no exact JSON numbers
  flag,         ///< true or false
  number,       ///< finite
  text,
  indices,  ///< an array of index
  numbers,  ///< an array of number
};

/// A value of another JSON type than the member has, or a number that is no integer where one must be. Who
/// wrote it did not write glTF, so this matters wherever it stands.
class WrongKind : public Error {
 public:
  WrongKind(std::string place, const std::string& what)
      : Error(Code::invalid_input, std::move(place), what) {}
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
/// Throws:     WrongKind naming the member, Error::invalid_input where it is missing or of a wrong length
Json checked_members(const Json& object, const std::string& place, std::span<const JsonMember> members);

/// Throws WrongKind unless the value is of that type.
void require_object(const Json& value, const std::string& place);
void require_array(const Json& value, const std::string& place);

}  // namespace provis
