#include "src/scene/failure.hpp"

#include <utility>

namespace provis {

void fail_invalid(std::string place, const std::string& what) {
  throw Error(Error::Code::invalid_input, std::move(place), what);
}

void fail_unsupported(std::string place, const std::string& what) {
  throw Error(Error::Code::unsupported, std::move(place), what);
}

std::string what_of(const Error& error) {
  const std::string message = error.what();
  return error.place().empty() ? message : message.substr(error.place().size() + 2);
}

Error in_file(const std::string& file, const Error& error) {
  const std::string place = error.place().empty() ? file : file + ": " + error.place();
  return Error(error.code(), place, what_of(error));
}

}  // namespace provis
