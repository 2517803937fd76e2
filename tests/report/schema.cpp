#include "tests/report/schema.hpp"

#include <algorithm>
#include <set>

namespace provis {

namespace {

using Json = nlohmann::json;

bool has_type(const Json& value, const Json& types) {
  if (types.is_array()) {
    return std::any_of(types.begin(), types.end(), [&](const Json& type) { return has_type(value, type); });
  }
  const auto type = types.get<std::string>();
  if (type == "null") return value.is_null();
  if (type == "object") return value.is_object();
  if (type == "array") return value.is_array();
  if (type == "string") return value.is_string();
  if (type == "boolean") return value.is_boolean();
  if (type == "integer") return value.is_number_integer();
  return type == "number" && value.is_number();
}

class Validator {
 public:
  explicit Validator(const Json& root) : root_(root) {}

  std::vector<std::string> violations(const Json& schema, const Json& value, const std::string& place) const {
    std::vector<std::string> found;
    const auto demand = [&](bool holds, const std::string& what) {
      if (!holds) found.push_back(place + ": " + what);
    };
    const auto descend = [&](const Json& sub, const Json& part, const std::string& name) {
      const auto more = violations(sub, part, place + "/" + name);
      found.insert(found.end(), more.begin(), more.end());
    };
    for (const auto& [keyword, rule] : schema.items()) {
      if (keyword == "$schema" || keyword == "title" || keyword == "description" || keyword == "$defs")
        continue;
      if (keyword == "$ref") {
        descend(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value, "");
      } else if (keyword == "type") {
        demand(has_type(value, rule), "is no " + rule.dump());
      } else if (keyword == "const") {
        demand(value == rule, "is not " + rule.dump());
      } else if (keyword == "enum") {
        demand(std::find(rule.begin(), rule.end(), value) != rule.end(), "is not one of " + rule.dump());
      } else if (keyword == "minimum") {
        demand(!value.is_number() || value >= rule, "is below " + rule.dump());
      } else if (keyword == "minItems") {
        demand(!value.is_array() || value.size() >= rule, "holds too few");
      } else if (keyword == "maxItems") {
        demand(!value.is_array() || value.size() <= rule, "holds too many");
      } else if (keyword == "minLength") {
        demand(!value.is_string() || value.get<std::string>().size() >= rule, "is too short");
      } else if (keyword == "maxLength") {
        demand(!value.is_string() || value.get<std::string>().size() <= rule, "is too long");
      } else if (keyword == "required") {
        if (!value.is_object()) continue;
        for (const Json& key : rule) demand(value.contains(key.get<std::string>()), "lacks " + key.dump());
      } else if (keyword == "properties") {
        for (const auto& [key, sub] : rule.items()) {
          if (value.contains(key)) descend(sub, value[key], key);
        }
      } else if (keyword == "additionalProperties") {
        if (!value.is_object()) continue;
        for (const auto& [key, part] : value.items()) {
          if (schema.contains("properties") && schema["properties"].contains(key)) continue;
          if (rule.is_boolean()) {
            demand(rule, "has the unknown member " + key);
          } else {
            descend(rule, part, key);
          }
        }
      } else if (keyword == "items" || keyword == "prefixItems") {
        if (!value.is_array()) continue;
        for (std::size_t i = 0; i < value.size(); ++i) {
          if (keyword == "items") descend(rule, value[i], std::to_string(i));
          if (keyword == "prefixItems" && i < rule.size()) descend(rule[i], value[i], std::to_string(i));
        }
      } else if (keyword == "oneOf") {
        const auto fits = [&](const Json& sub) { return violations(sub, value, place).empty(); };
        demand(std::count_if(rule.begin(), rule.end(), fits) == 1, "fits not exactly one alternative");
      } else {
        demand(false, "the schema uses the unknown keyword " + keyword);
      }
    }
    return found;
  }

 private:
  const Json& root_;
};

}  // namespace

std::vector<std::string> schema_violations(const nlohmann::json& schema, const nlohmann::json& value) {
  return Validator(schema).violations(schema, value, "");
}

}  // namespace provis
