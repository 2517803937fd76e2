#include "src/report/json_node.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "provis/error.hpp"

namespace provis {

nlohmann::json parse_json_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in || in.peek() == std::ifstream::traits_type::eof()) {
    throw Error(Error::Code::invalid_input, file, "cannot be read, or is empty");
  }
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::parse_error& error) {
    throw Error(Error::Code::invalid_input, fmt::format("{}: byte {}", file, error.byte), "not valid JSON");
  } catch (const nlohmann::json::exception& error) {
    throw Error(Error::Code::invalid_input, file, fmt::format("not usable JSON: {}", error.what()));
  }
}

void JsonNode::fail(const std::string& what) const {
  throw Error(Error::Code::invalid_input, place_.empty() ? file_ : file_ + ": " + place_, what);
}

JsonNode JsonNode::member(std::string_view key) const {
  if (!value_->is_object()) fail("is not an object");
  const auto found = value_->find(key);
  if (found == value_->end()) fail(fmt::format("has no member \"{}\"", key));
  return {*found, file_, place_.empty() ? std::string(key) : fmt::format("{}.{}", place_, key)};
}

std::vector<JsonNode> JsonNode::items() const {
  if (!value_->is_array()) fail("is not an array");
  std::vector<JsonNode> nodes;
  nodes.reserve(value_->size());
  for (const nlohmann::json& item : *value_) {
    nodes.push_back(JsonNode(item, file_, fmt::format("{}[{}]", place_, nodes.size())));
  }
  return nodes;
}

std::vector<JsonNode> JsonNode::items(std::size_t count) const {
  std::vector<JsonNode> nodes = items();
  if (nodes.size() != count) fail(fmt::format("holds {} values instead of {}", nodes.size(), count));
  return nodes;
}

double JsonNode::number() const {
  if (!value_->is_number()) fail("is not a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail("is not finite");
  return number;
}

std::uint64_t JsonNode::natural() const {
  if (!value_->is_number_unsigned()) fail("is not a natural number");
  return value_->get<std::uint64_t>();
}

std::int64_t JsonNode::integer() const {
  const bool fits = value_->is_number_integer() &&
                    (!value_->is_number_unsigned() ||
                     value_->get<std::uint64_t>() <= std::uint64_t(std::numeric_limits<std::int64_t>::max()));
  if (!fits) fail("is not an integer");
  return value_->get<std::int64_t>();
}

bool JsonNode::boolean() const {
  if (!value_->is_boolean()) fail("is neither true nor false");
  return value_->get<bool>();
}

const std::string& JsonNode::text() const {
  if (!value_->is_string()) fail("is not a string");
  return value_->get_ref<const std::string&>();
}

Vec3d JsonNode::vec3() const {
  const std::vector<JsonNode> n = items(3);
  return {n[0].number(), n[1].number(), n[2].number()};
}

Window JsonNode::window() const {
  const std::vector<JsonNode> n = items(4);
  return {n[0].number(), n[1].number(), n[2].number(), n[3].number()};
}

}  // namespace provis
