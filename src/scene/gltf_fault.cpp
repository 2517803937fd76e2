#include "src/scene/gltf_fault.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "src/scene/failure.hpp"

namespace provis {
namespace {

constexpr char unsupported_key[] = "unsupported", place_key[] = "place", what_key[] = "what";

}  // namespace

Json faulty(Json placeholder, const Error& error) {
  placeholder["extras"] = {{unsupported_key, error.code() == Error::Code::unsupported},
                           {place_key, error.place()},
                           {what_key, what_of(error)}};
  return placeholder;
}

void check_usable(const tinygltf::Value& extras) {
  if (!extras.IsObject()) return;
  const Error::Code code =
      extras.Get(unsupported_key).Get<bool>() ? Error::Code::unsupported : Error::Code::invalid_input;
  throw Error(code, extras.Get(place_key).Get<std::string>(), extras.Get(what_key).Get<std::string>());
}

}  // namespace provis
