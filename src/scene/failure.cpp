#include "src/scene/failure.hpp"

#include <utility>

namespace provis {

void fail_invalid(std::string place, const std::string& what) {
  throw Error(Error::Code::invalid_input, std::move(place), what);
}

void fail_unsupported(std::string place, const std::string& what) {
  throw Error(Error::Code::unsupported, std::move(place), what);
}

Error in_file(const std::string& file, const Error& error) {
  if (error.place().empty()) return Error(error.code(), file, error.what());
  // what() repeats the place; it must stand only once in the new message.
  const std::string what = std::string(error.what()).substr(error.place().size() + 2);
  return Error(error.code(), file + ": " + error.place(), what);
}

}  // namespace provis
