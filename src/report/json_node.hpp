#pragma once
// A value of a parsed JSON file that knows its place, so that every complaint can name it.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "provis/view.hpp"

namespace provis {

/// Throws:     Error::invalid_input naming file and byte offset
nlohmann::json parse_json_file(const std::string& file);

/// A view into a JSON value that outlives it. Every accessor throws Error::invalid_input, naming file
/// and member, when the value is not what is asked for.
class JsonNode {
 public:
  JsonNode(const nlohmann::json& value, std::string file) : value_(&value), file_(std::move(file)) {}

  const nlohmann::json& raw() const { return *value_; }
  bool has(std::string_view key) const { return value_->is_object() && value_->contains(key); }

  JsonNode member(std::string_view key) const;
  std::vector<JsonNode> items() const;
  std::vector<JsonNode> items(std::size_t count) const;

  double number() const;  ///< finite
  std::uint64_t natural() const;
  std::int64_t integer() const;
  bool boolean() const;
  const std::string& text() const;
  Vec3d vec3() const;     ///< [x, y, z]
  Window window() const;  ///< [x0, x1, y0, y1]

  [[noreturn]] void fail(const std::string& what) const;

 private:
  JsonNode(const nlohmann::json& value, std::string file, std::string place)
      : value_(&value), file_(std::move(file)), place_(std::move(place)) {}

  const nlohmann::json* value_;
  std::string file_;
  std::string place_;  ///< "query.window[2]"; empty for the whole file
};

}  // namespace provis
