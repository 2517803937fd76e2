#pragma once
// As much of JSON Schema as the schemas of src/report use.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace provis {

/// Every violation, as "place: what"; empty if the value is valid. An unknown keyword is a violation too,
/// so that nothing in the schema goes unchecked.
std::vector<std::string> schema_violations(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace provis
